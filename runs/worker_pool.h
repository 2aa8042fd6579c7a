// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>

namespace pacer {

/// One piece of work, done in a worker process. Its result travels back as bytes.
using WorkerTask = std::function<std::string(std::uint32_t index)>;
/// Called in the parent about ten times a second: the place to show progress.
using WorkerTick = std::function<void()>;
/// Takes results in the parent, in the order of the indices, whatever order they were done in.
using ResultSink = std::function<void(std::uint32_t index, std::string result)>;

/// Does `task(index)` for every index in `jobs` worker processes (forked, so that each has a GL
/// context and an address space of its own; they die with the parent). The results, and so
/// whatever is made of them in order, do not depend on `jobs`. A worker draws with one thread,
/// unless LP_NUM_THREADS says otherwise.
///
/// Returns false when `stop` ended it early: workers are told to end at once, and what came in
/// order before that has been handed to `on_result`.
/// Throws std::runtime_error with the worker's message when a task throws, UsageError when it
/// threw one, and says which index
/// was lost when a worker dies.
bool run_in_workers(int jobs, std::span<const std::uint32_t> indices, const WorkerTask& task,
                    const ResultSink& on_result, const std::stop_token& stop,
                    const WorkerTick& tick = {});

}  // namespace pacer
