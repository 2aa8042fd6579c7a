// SPDX-License-Identifier: Apache-2.0
// Private to the module: where a sequence's parts lie.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/picture_list.h"
#include "dataset/sequence.h"

namespace pacer::dataset {

/// The last part of a path, also of ".", "..", and of one that ends in a slash.
[[nodiscard]] std::string sequence_name(const std::filesystem::path& path);

/// An annotation on disk.
struct TruthFile {
  std::string target;  ///< "" where there is one
  std::filesystem::path path;
};

/// The annotations of a sequence's folder: the layout is told by their names. OTB's
/// groundtruth_rect.txt, or groundtruth_rect.1.txt and on; VOT's and GOT-10k's groundtruth.txt, or
/// VOT's groundtruth_NAME.txt beside a `sequence` file; TLD's gt.txt. A groundtruth.txt is
/// GOT-10k's where absence.label, cover.label or meta_info.ini lies beside it, or the folder is
/// named as GOT-10k's are (its test split has no labels), and no `sequence` file does.
struct TruthFiles {
  SequenceLayout layout = SequenceLayout::kOtb;
  std::vector<TruthFile> files;
};

/// Empty where `folder` has no annotation. Throws std::runtime_error when it cannot be listed.
[[nodiscard]] std::optional<TruthFiles> find_truth(const std::filesystem::path& folder);

/// Holds pictures or properties as a sequence's folder does, annotated or not.
[[nodiscard]] bool looks_like_sequence(const std::filesystem::path& folder);

/// The pictures of a sequence: where the layout has them, else in the folder itself. VOT's lie
/// where its `sequence` file says (channels.color=color/%08d.jpg; else depth, else ir). None where
/// there are none. Throws std::runtime_error for what is wrong with the folder or that file.
[[nodiscard]] std::vector<NumberedPicture> find_pictures(const std::filesystem::path& folder,
                                                         SequenceLayout layout);

/// The one video of a folder; empty where there is none. Throws std::runtime_error for two.
[[nodiscard]] std::optional<std::filesystem::path> find_video(const std::filesystem::path& folder);

}  // namespace pacer::dataset
