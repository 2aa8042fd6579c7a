// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

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
  pacer::add_inspect(app, stop);
  pacer::add_study(app, stop);
  pacer::add_doctor(app, stop);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RequiredError& error) {
    if (argc > 1 && app.get_subcommands().empty()) {
      fmt::print(stderr, "pacer: {}: no such command; `pacer --help` lists them\n", argv[1]);
      return kBadUsage;
    }
    return app.exit(error) == 0 ? 0 : kBadUsage;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUsage;
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
