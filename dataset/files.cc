// SPDX-License-Identifier: Apache-2.0
#include "dataset/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/murmur3.h>
}

#include "core/check.h"

namespace pacer::dataset {
namespace {

constexpr auto kPatience = std::chrono::seconds(10);

/// What to do about an `error` of what was tried.
const char* advice(int error, std::string_view what) {
  if (error == ENOSPC || error == EDQUOT) return "; free some space and run again";
  const bool making = what == "write" || what == "make the folder";
  return making ? "; name a place that can be written" : "";
}

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  const int error = errno;
  throw std::runtime_error(fmt::format("{}: cannot {}: {}{}", path.string(), what,
                                       std::generic_category().message(error),
                                       advice(error, what)));
}

/// An open file that closes itself.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags, const char* what)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) fail(path, what);
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// Hands the file to `take` piece by piece.
template <class Take>
void read_pieces(const std::filesystem::path& path, Take&& take) {
  const Descriptor file(path, O_RDONLY, "read");
  std::vector<char> piece(1U << 16U);
  for (;;) {
    const ssize_t got = ::read(file.number(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "read");
    if (got == 0) return;
    take(std::string_view(piece.data(), static_cast<std::size_t>(got)));
  }
}

}  // namespace

std::string read_text(const std::filesystem::path& path, std::uintmax_t most) {
  std::string text;
  read_pieces(path, [&](std::string_view piece) {
    if (text.size() + piece.size() > most) {
      throw std::runtime_error(fmt::format("{}: larger than {} bytes", path.string(), most));
    }
    text += piece;
  });
  return text;
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC, "write");
  while (!text.empty()) {
    const ssize_t put = ::write(file.number(), text.data(), text.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) fail(path, "write");
    text.remove_prefix(static_cast<std::size_t>(put));
  }
  if (::fsync(file.number()) != 0) fail(path, "write");
}

void replace_text(const std::filesystem::path& path, const std::filesystem::path& by_way_of,
                  std::string_view text) {
  write_text(by_way_of, text);
  move(by_way_of, path);
}

void sync(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY, "open");
  // Some file systems know no sync of a folder, and say so.
  if (::fsync(file.number()) != 0 && errno != EINVAL) fail(path, "write");
}

void move(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) {
    fail(from, fmt::format("move to {}", to.string()).c_str());
  }
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    errno = error.value();
    fail(path, "make the folder");
  }
}

std::vector<std::filesystem::path> list_files(const std::filesystem::path& folder,
                                              std::size_t most) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code error;
  if (!fs::is_directory(folder, error)) return files;
  for (fs::directory_iterator each(folder, error); !error && each != fs::directory_iterator();
       each.increment(error)) {
    std::error_code gone;
    if (each->path().filename().string().starts_with('.') || !each->is_regular_file(gone)) continue;
    if (files.size() == most) {
      throw std::runtime_error(fmt::format("{}: holds more than {} files", folder.string(), most));
    }
    files.push_back(each->path());
  }
  if (error) {
    errno = error.value();
    fail(folder, "list");
  }
  std::ranges::sort(files);
  return files;
}

FolderLock::FolderLock(const std::filesystem::path& folder) {
  Descriptor file(folder, O_RDONLY | O_DIRECTORY, "open");
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (::flock(file.number(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) fail(folder, "lock");
    if (std::chrono::steady_clock::now() > end) {
      throw UsageError(fmt::format("{}: another process is writing it; wait for it, or end it",
                                   folder.string()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  descriptor_ = file.release();
}

FolderLock::~FolderLock() { ::close(descriptor_); }

struct ContentHash::Impl {
  AVMurMur3* state = av_murmur3_alloc();
};

ContentHash::ContentHash() : impl_(std::make_unique<Impl>()) {
  if (impl_->state == nullptr) throw std::bad_alloc();
  av_murmur3_init(impl_->state);
}

ContentHash::~ContentHash() { av_free(impl_->state); }

void ContentHash::add(std::string_view bytes) {
  av_murmur3_update(impl_->state, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                    bytes.size());
}

void ContentHash::add_file(const std::filesystem::path& path) {
  read_pieces(path, [&](std::string_view piece) { add(piece); });
}

std::string ContentHash::finish() {
  std::array<std::uint8_t, 16> digest{};
  av_murmur3_final(impl_->state, digest.data());
  std::string text;
  for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

std::string hash_of_file(const std::filesystem::path& path) {
  ContentHash hash;
  hash.add_file(path);
  return hash.finish();
}

}  // namespace pacer::dataset
