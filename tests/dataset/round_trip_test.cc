// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/check.h"
#include "dataset/demonstration.h"
#include "dataset/reader.h"
#include "dataset/replay_car.h"
#include "tests/contract/car_contract.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::made_up_step;
using testing::MadeUpStep;
using testing::record_dataset;
using testing::Scratch;
using testing::small_spec;

double mean_distance(const Frame& one, const Frame& other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < one.rgb.size(); ++i) sum += std::abs(one.rgb[i] - other.rgb[i]);
  return sum / static_cast<double>(one.rgb.size());
}

TEST(Dataset, GivesBackEveryValueThatWasRecorded) {
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  record_dataset(scratch / "set", spec, 2, 9);
  const Dataset dataset(scratch / "set");
  ASSERT_EQ(dataset.episodes().size(), 2U);
  EXPECT_EQ(dataset.info().frames, 9 + 10);
  EXPECT_EQ(dataset.scenario(), spec.scenario);
  EXPECT_EQ(dataset.task(), spec.task);
  EpisodeReader reader(dataset, 1,
                       {"observation.state", "action", "wanted", "driver", "pulses", "capture_time",
                        "privileged.lead_box", "privileged.lead_in_view", "timestamp", "index"});
  Command last;
  for (std::int64_t i = 0; i < 10; ++i) {
    const RecordedStep* step = reader.next();
    ASSERT_NE(step, nullptr);
    const MadeUpStep made = made_up_step(spec, 1, i);
    EXPECT_LT(mean_distance(*step->frame, made.frame), 4.0) << "frame " << i;
    EXPECT_EQ(step->frame->index, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(step->frame->time.count(), static_cast<double>(i) / 25.0, 1e-9);
    const std::span<const double> values = step->values;
    ASSERT_EQ(values.size(), 17U);
    EXPECT_FLOAT_EQ(static_cast<float>(values[0]), static_cast<float>(last.steering));
    EXPECT_FLOAT_EQ(static_cast<float>(values[1]), static_cast<float>(last.throttle));
    EXPECT_FLOAT_EQ(static_cast<float>(values[2]), static_cast<float>(made.sent.steering));
    EXPECT_FLOAT_EQ(static_cast<float>(values[3]), static_cast<float>(made.sent.throttle));
    EXPECT_FLOAT_EQ(static_cast<float>(values[4]), static_cast<float>(made.wanted.steering));
    EXPECT_FLOAT_EQ(static_cast<float>(values[5]), static_cast<float>(made.wanted.throttle));
    EXPECT_EQ(values[6], 0.0) << "the teacher";
    EXPECT_EQ(values[7], 1500.0 + 0.25 * static_cast<double>(i));
    EXPECT_EQ(values[8], 1250.0 - 0.25 * static_cast<double>(i));
    EXPECT_NEAR(values[9], static_cast<double>(i) / 25.0, 1e-9);
    for (std::size_t s = 0; s < 5; ++s) EXPECT_EQ(values[10 + s], made.signals[s]);
    EXPECT_FLOAT_EQ(static_cast<float>(values[15]), static_cast<float>(i) / 25.0F);
    EXPECT_EQ(values[16], static_cast<double>(9 + i)) << "counted over all episodes";
    last = made.sent;
  }
  EXPECT_EQ(reader.next(), nullptr);
  EXPECT_EQ(reader.next(), nullptr);
}

TEST(Dataset, LeavesNothingUnfinishedBehind) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 1, 5);
  EXPECT_FALSE(std::filesystem::exists(scratch / "set" / ".unfinished"));
}

TEST(Dataset, RefusesAFolderWithoutOne) {
  const Scratch scratch;
  EXPECT_THROW(Dataset{scratch / "nowhere"}, UsageError);
}

TEST(Dataset, FingerprintTellsContentsApart) {
  const Scratch scratch;
  DatasetSpec spec = small_spec();
  record_dataset(scratch / "one", spec, 1, 5);
  record_dataset(scratch / "same", spec, 1, 5);
  record_dataset(scratch / "longer", spec, 1, 6);
  const std::string fingerprint = Dataset(scratch / "one").fingerprint();
  EXPECT_EQ(fingerprint.size(), 32U);
  EXPECT_EQ(fingerprint, Dataset(scratch / "same").fingerprint());
  EXPECT_NE(fingerprint, Dataset(scratch / "longer").fingerprint());
}

TEST(RecordedDemonstration, StreamsFramesAndWhatWasSent) {
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  record_dataset(scratch / "set", spec, 2, 6);
  const RecordedDemonstration demonstration(scratch / "set");
  EXPECT_EQ(demonstration.episode_count(), 2U);
  EXPECT_EQ(demonstration.frame_rate_hz(), 25.0);
  EXPECT_EQ(demonstration.image_size(), spec.image_size);
  const auto stream = demonstration.open(0);
  for (std::int64_t i = 0; i < 6; ++i) {
    const DemonstratedStep* step = stream->next();
    ASSERT_NE(step, nullptr);
    EXPECT_EQ(step->frame->index, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(step->command.steering, made_up_step(spec, 0, i).sent.steering, 1e-7);
  }
  EXPECT_EQ(stream->next(), nullptr);
}

TEST(RecordedDemonstration, SeesNoPrivilegedColumn) {
  // The same drive twice, and all that only the simulator knows another time: a learner is handed
  // the same steps.
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  for (const char* name : {"one", "other"}) {
    DatasetWriter writer(scratch / name, spec);
    EpisodeRecorder recorder(scratch / name, spec, 0);
    for (std::int64_t i = 0; i < 5; ++i) {
      MadeUpStep made = made_up_step(spec, 0, i);
      if (std::string(name) == "other") made.signals.assign(5, -1.0F);
      ASSERT_TRUE(recorder.write(made.frame, made.step()));
    }
    recorder.finish();
    writer.commit();
  }
  const RecordedDemonstration one(scratch / "one");
  const RecordedDemonstration other(scratch / "other");
  ASSERT_NE(one.fingerprint(), other.fingerprint());
  const auto left = one.open(0);
  const auto right = other.open(0);
  for (int i = 0; i < 5; ++i) {
    const DemonstratedStep* a = left->next();
    const DemonstratedStep* b = right->next();
    ASSERT_NE(a, nullptr);
    ASSERT_NE(b, nullptr);
    EXPECT_EQ(a->command, b->command);
    EXPECT_EQ(a->frame->rgb, b->frame->rgb);
    EXPECT_EQ(a->frame->time, b->frame->time);
  }
}

TEST(ReplayCar, BringsBackTheSignalsOfTheRecordedCar) {
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  record_dataset(scratch / "set", spec, 1, 4);
  const Dataset dataset(scratch / "set");
  ReplayCar car(dataset, 0);
  EXPECT_TRUE(std::ranges::equal(car.signal_columns(), spec.signals));
  ASSERT_NE(car.look(), nullptr);
  EXPECT_TRUE(std::ranges::equal(car.signals(), made_up_step(spec, 0, 0).signals));
}

/// A car on a recording of its own.
struct ReplayCarFactory {
  struct Owner {
    Scratch scratch;
    std::unique_ptr<Dataset> dataset;
  };
  struct OwningCar final : Car {
    OwningCar() {
      record_dataset(owner.scratch / "set", small_spec(), 1, 15);
      owner.dataset = std::make_unique<Dataset>(owner.scratch / "set");
      car = std::make_unique<ReplayCar>(*owner.dataset, 0);
    }
    const Frame* look() override { return car->look(); }
    void send(const Pulses& pulses) override { car->send(pulses); }
    std::span<const SignalColumn> signal_columns() const override { return car->signal_columns(); }
    SignalValues signals() const override { return car->signals(); }

    Owner owner;
    std::unique_ptr<ReplayCar> car;
  };
  std::unique_ptr<Car> operator()() const { return std::make_unique<OwningCar>(); }
};

}  // namespace
}  // namespace pacer::dataset

namespace pacer::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(Replay, CarContract, pacer::dataset::ReplayCarFactory);
}
