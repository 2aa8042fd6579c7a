// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <csignal>
#include <opencv2/core/utility.hpp>

#include "apps/command.h"
#include "apps/interrupt.h"
#include "core/check.h"
#include "core/version.h"

namespace {

constexpr int kFailed = 1;
constexpr int kBadUsage = 2;

}  // namespace

int main(int argc, char** argv) {
  const std::stop_token stop = pacer::stop_on_interrupt();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like any other
  cv::setNumThreads(1);  // work is spread over processes; results do not depend on the machine
  CLI::App app("pacer: teach a car to drive by showing it, in simulation and on the floor.",
               "pacer");
  app.set_version_flag("--version", pacer::kVersion);
  app.require_subcommand(1);
  app.footer("Begin with:  pacer collect scenarios/follow.yaml --episodes 5 --out out/drives");
  pacer::add_collect(app, stop);
  pacer::add_train(app, stop);
  pacer::add_evaluate(app, stop);
  pacer::add_drive(app, stop);
  pacer::add_sequences(app, stop);
  pacer::add_track(app, stop);
  pacer::add_inspect(app, stop);
  pacer::add_study(app, stop);
  pacer::add_doctor(app, stop);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help, or the version
    const auto named = app.get_subcommands();
    if (named.empty() && argc > 1) {
      fmt::print(stderr, "pacer: {}: no such command; `pacer --help` lists them\n", argv[1]);
    } else {
      fmt::print(stderr, "pacer: {}; `pacer{} --help` shows how\n", error.what(),
                 named.empty() ? "" : " " + named.front()->get_name());
    }
    return kBadUsage;
  } catch (const pacer::Unfinished&) {
    return kFailed;
  } catch (const pacer::UsageError& error) {
    fmt::print(stderr, "pacer: {}\n", error.what());
    return kBadUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pacer: {}\n", error.what());
    return kFailed;
  }
}
