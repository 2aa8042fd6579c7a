// SPDX-License-Identifier: Apache-2.0
#include "runs/worker_pool.h"

#include <fmt/format.h>
#include <malloc.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "core/check.h"

namespace pacer {
namespace {

/// A message from a worker: this header, then `size` bytes.
struct Header {
  std::uint32_t index = 0;
  std::uint32_t kind = 0;
  std::uint64_t size = 0;
};
enum Kind : std::uint32_t { kStarted = 0, kDone = 1, kFailed = 2, kMisused = 3 };

class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileDescriptor() { close(); }
  void close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_ = -1;
};

std::pair<FileDescriptor, FileDescriptor> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

/// Reads exactly `size` bytes; false at the end of the stream.
bool read_all(int fd, void* to, std::size_t size) {
  auto* bytes = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t got = ::read(fd, bytes, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool write_all(int fd, const void* from, std::size_t size) {
  const auto* bytes = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t put = ::write(fd, bytes, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    bytes += put;
    size -= static_cast<std::size_t>(put);
  }
  return true;
}

void send(int fd, std::uint32_t index, Kind kind, const std::string& text) {
  const Header header{.index = index, .kind = kind, .size = text.size()};
  if (!write_all(fd, &header, sizeof header) || !write_all(fd, text.data(), text.size())) {
    ::_exit(1);  // nobody listens any more
  }
}

/// A worker keeps to one core and gives back what it no longer needs.
void be_modest() {
  ::setenv("LP_NUM_THREADS", "0", 0);  // Mesa would draw with a thread a processor
#ifdef __GLIBC__
  constexpr int kLarge = 1 << 20;  // bytes: a room's textures and buffers go when the room goes
  ::mallopt(M_MMAP_THRESHOLD, kLarge);
  ::mallopt(M_TRIM_THRESHOLD, 16 * kLarge);  // but not what every frame asks for again
  ::mallopt(M_ARENA_MAX, 1);
#endif
}

/// The life of a worker: takes the next index until there is none. Never returns.
[[noreturn]] void work(pid_t parent, int indices, int results, const WorkerTask& task) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it died before it could be watched
  std::signal(SIGINT, SIG_IGN);           // they may reach the whole group: the parent decides
  std::signal(SIGTERM, SIG_IGN);
  be_modest();
  std::uint32_t index = 0;
  while (read_all(indices, &index, sizeof index)) {
    send(results, index, kStarted, "");
    try {
      send(results, index, kDone, task(index));
    } catch (const UsageError& error) {
      send(results, index, kMisused, error.what());
    } catch (const std::exception& error) {
      send(results, index, kFailed, error.what());
    }
  }
  ::_exit(0);  // no destructors of the parent's objects
}

struct Worker {
  pid_t pid = -1;
  FileDescriptor results;
  std::optional<std::uint32_t> busy_with;
};

/// The worker processes; none outlives it.
class Crew {
 public:
  Crew(int jobs, std::span<const std::uint32_t> indices, const WorkerTask& task) {
    auto [taking, giving] = make_pipe();
    // The queue is filled before anyone reads, so every read takes one whole index.
    constexpr std::size_t kPipeHolds = 65536;
    if (indices.size_bytes() > kPipeHolds) {
      throw std::invalid_argument("more than 16384 pieces of work in one run");
    }
    if (!write_all(giving.get(), indices.data(), indices.size_bytes())) {
      throw std::system_error(errno, std::generic_category(), "pipe to the workers");
    }
    giving.close();
    const pid_t parent = ::getpid();
    const auto count = std::min<std::size_t>(static_cast<std::size_t>(jobs), indices.size());
    for (std::size_t i = 0; i < count; ++i) {
      auto [in, out] = make_pipe();
      const pid_t pid = ::fork();
      if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
      if (pid == 0) {
        in.close();
        work(parent, taking.get(), out.get(), task);
      }
      workers_.push_back({.pid = pid, .results = std::move(in), .busy_with = {}});
    }
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  ~Crew() {
    for (Worker& worker : workers_) ::kill(worker.pid, SIGKILL);
    for (Worker& worker : workers_) (void)reap(worker);
  }

  /// Waits a little for messages and hands each to `take(header, text)`; false when all workers
  /// have ended.
  template <class Take>
  bool listen(Take&& take) {
    std::vector<pollfd> polled;
    for (const Worker& worker : workers_) {
      polled.push_back({.fd = worker.results.get(), .events = POLLIN, .revents = 0});
    }
    if (polled.empty()) return false;
    constexpr int kPatienceMs = 100;
    if (::poll(polled.data(), polled.size(), kPatienceMs) <= 0) return true;
    for (std::size_t i = polled.size(); i-- > 0;) {
      if (polled[i].revents == 0) continue;
      Header header;
      std::string text;
      if (!read_all(polled[i].fd, &header, sizeof header)) {
        bury(i);
        continue;
      }
      text.resize(header.size);
      if (!read_all(polled[i].fd, text.data(), text.size())) {
        bury(i);
        continue;
      }
      workers_[i].busy_with.reset();
      if (header.kind == kStarted) workers_[i].busy_with = header.index;
      take(header, std::move(text));
    }
    return true;
  }

 private:
  static int reap(Worker& worker) {
    int status = 0;
    while (::waitpid(worker.pid, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
  }

  void bury(std::size_t i) {
    Worker worker = std::move(workers_[i]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    const int status = reap(worker);
    if (!worker.busy_with) return;
    const std::string how = WIFSIGNALED(status)
                                ? fmt::format("was ended by signal {}", WTERMSIG(status))
                                : fmt::format("ended with status {}", WEXITSTATUS(status));
    throw std::runtime_error(
        fmt::format("a worker {} at number {}; what was finished before is kept, and the same "
                    "command goes on from there",
                    how, *worker.busy_with));
  }

  std::vector<Worker> workers_;
};

}  // namespace

bool run_in_workers(int jobs, std::span<const std::uint32_t> indices, const WorkerTask& task,
                    const ResultSink& on_result, const std::stop_token& stop,
                    const WorkerTick& tick) {
  if (indices.empty()) return true;
  std::map<std::uint32_t, std::string> waiting;  // done, but not yet in turn
  std::size_t handed = 0;
  Crew crew(std::max(jobs, 1), indices, task);
  const auto take = [&](const Header& header, std::string text) {
    if (header.kind == kMisused) throw UsageError(text);
    if (header.kind == kFailed) throw std::runtime_error(text);
    if (header.kind == kDone) waiting.emplace(header.index, std::move(text));
    while (handed < indices.size()) {
      const auto next = waiting.find(indices[handed]);
      if (next == waiting.end()) break;
      on_result(next->first, std::move(next->second));
      waiting.erase(next);
      ++handed;
    }
  };
  while (handed < indices.size() && !stop.stop_requested()) {
    if (!crew.listen(take)) break;
    if (tick) tick();
  }
  return handed == indices.size();
}

}  // namespace pacer
