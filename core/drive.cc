// SPDX-License-Identifier: Apache-2.0
#include "core/drive.h"

namespace pacer {
namespace {

/// Sends neutral when it goes out of scope, however that happens.
class NeutralOnExit {
 public:
  NeutralOnExit(Car& car, const Channels& channels) : car_(car), neutral_(channels.neutral()) {}
  NeutralOnExit(const NeutralOnExit&) = delete;
  NeutralOnExit& operator=(const NeutralOnExit&) = delete;
  ~NeutralOnExit() {
    try {
      car_.send(neutral_);
    } catch (...) {  // the link itself is gone: the receiver's failsafe has to stop the car
    }
  }

 private:
  Car& car_;
  Pulses neutral_;
};

}  // namespace

bool Sinks::write(const Frame& frame, const Step& step) {
  bool go_on = true;
  for (StepSink* sink : sinks_) go_on = sink->write(frame, step) && go_on;
  return go_on;
}

std::uint64_t drive(Car& car, Policy& driver, const Limits& limits, const Channels& channels,
                    StepSink& sink, const std::stop_token& stop) {
  const NeutralOnExit guard(car, channels);
  std::uint64_t steps = 0;
  Command last;
  Seconds before{};
  Annotations annotations;
  while (!stop.stop_requested()) {
    const Frame* frame = car.look();
    if (frame == nullptr) break;
    annotations.clear();
    const Command wanted = driver.act({.frame = *frame, .last = last}, annotations);
    const Seconds elapsed = steps == 0 ? Seconds{} : frame->time - before;
    const Command sent = limits.apply(wanted, last, elapsed);
    const Pulses pulses = channels.encode(sent);
    car.send(pulses);
    ++steps;
    last = sent;
    before = frame->time;
    if (!sink.write(*frame, {.wanted = wanted,
                             .sent = sent,
                             .pulses = pulses,
                             .driver = driver.driver(),
                             .signals = car.signals(),
                             .annotations = annotations})) {
      break;
    }
  }
  return steps;
}

}  // namespace pacer
