// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <vector>

#include "dataset/reader.h"
#include "runs/policy_source.h"
#include "runs/report/charts.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/turn_signal.h"

namespace pacer {
namespace {

constexpr std::uint64_t kEpisodes = 5;

/// The turn signals of one episode.
struct EpisodeSignals {
  std::vector<double> time_s;
  std::vector<double> teacher;
  std::vector<std::vector<double>> policies;
};

/// Lets policies watch a recorded drive of the teacher.
EpisodeSignals watch(const StudyContext& context, const dataset::Dataset& drives,
                     std::size_t episode, const std::vector<PolicySource>& sources) {
  std::vector<std::unique_ptr<Policy>> policies;
  for (const PolicySource& source : sources) {
    policies.push_back(source.make(context.scenario, nullptr, Random(context.scenario.seed)));
  }
  EpisodeSignals signals;
  signals.policies.resize(policies.size());
  dataset::EpisodeReader reader(drives, episode, {std::string(dataset::kAction)});
  Command last;
  Annotations ignored;
  while (const dataset::RecordedStep* step = reader.next()) {
    if (context.control.stop.stop_requested()) throw StudyStopped();
    signals.time_s.push_back(step->frame->time.count());
    for (std::size_t p = 0; p < policies.size(); ++p) {
      ignored.clear();
      const Command wanted = policies[p]->act({.frame = *step->frame, .last = last}, ignored);
      signals.policies[p].push_back(clamped(wanted).steering);
    }
    last = {.steering = step->values[0], .throttle = step->values[1]};
    signals.teacher.push_back(last.steering);
  }
  return signals;
}

void add_charts(const EpisodeSignals& signals, const std::vector<PolicySource>& sources,
                report::Page& page) {
  std::vector<std::string> names = {"teacher"};
  for (const PolicySource& source : sources) names.push_back(source.name());
  const report::Palette palette(names);
  report::Content& content = page.section("Turn signals (Figure 6.15)");
  content.paragraph(
      "An unseen drive of the teacher, and what each would have asked for on the same frames. In "
      "the thesis, the supervised signal has large peaks where the detector fires on something "
      "else; the median over many rules has few.");
  for (std::size_t p = 0; p < sources.size(); ++p) {
    const std::vector<report::Series> lines = {
        {.name = sources[p].name(), .x = signals.time_s, .y = signals.policies[p]},
        {.name = "teacher", .x = signals.time_s, .y = signals.teacher}};
    content.chart(
        {.spec = report::line_chart(lines, {.title = "time", .unit = "s"},
                                    {.title = "turn", .unit = "stick", .limits = Range{-1.0, 1.0}},
                                    palette, {.height_px = 220, .title = sources[p].name()}),
         .caption = {}});
  }
}

}  // namespace

/// Figure 6.15 on unseen drives of the teacher: the method, and the supervised baseline.
StudyResult study_signals(const StudyContext& context, report::Page& page) {
  const Materials materials(context);
  const std::uint64_t demonstrated = materials.five_minutes();
  const std::vector<PolicySource> sources =
      PolicySource::load({materials.model(demonstrated).string(),
                          materials.baseline("supervised", demonstrated).string()});
  const dataset::Dataset drives(materials.recording(Purpose::kStudy, kEpisodes));

  std::vector<SignalComparison> comparisons(sources.size());
  std::uint64_t frames = 0;
  for (std::size_t episode = 0; episode < kEpisodes; ++episode) {
    const EpisodeSignals signals = watch(context, drives, episode, sources);
    for (std::size_t p = 0; p < sources.size(); ++p) {
      comparisons[p].add_episode(signals.policies[p], signals.teacher);
    }
    frames += signals.teacher.size();
    if (episode == 0) add_charts(signals, sources, page);
    context.control.progress(episode + 1, kEpisodes, "episodes watched");
  }

  StudyResult result;
  report::Table table;
  table.columns = {{.heading = "policy"},
                   {.heading = "correlation", .decimals = 3},
                   {.heading = "rms error", .unit = "stick", .decimals = 3},
                   {.heading = "worst spike", .unit = "stick", .decimals = 3},
                   {.heading = "frames that stand out", .unit = "%", .decimals = 2}};
  std::vector<SignalMeasures> measured;
  for (std::size_t p = 0; p < sources.size(); ++p) {
    const SignalMeasures one = comparisons[p].measures();
    constexpr double kPercent = 100.0;
    table.rows.push_back({.cells = {sources[p].name(), one.correlation, one.rms_error,
                                    one.worst_spike, kPercent * one.spike_share}});
    result.figures[sources[p].name()] = {{"correlation", one.correlation},
                                         {"rms_error", one.rms_error},
                                         {"worst_spike", one.worst_spike},
                                         {"spike_share", one.spike_share}};
    measured.push_back(one);
  }
  result.figures["learned_correlation"] = measured[0].correlation;
  result.figures["supervised_correlation"] = measured[1].correlation;
  result.figures["learned_worst_spike"] = measured[0].worst_spike;
  result.figures["supervised_worst_spike"] = measured[1].worst_spike;
  result.figures["frames"] = frames;
  page.section("Against the teacher's")
      .table(table)
      .paragraph(fmt::format(
          "Over {} frames of {} drives. A frame stands out by its distance from the median of the "
          "eleven frames about it, as a false detection does; counted are those beyond {} of the "
          "stick. The supervised baseline is given the lead's box in every frame that it learns "
          "from.",
          frames, kEpisodes, kSpike));
  result.claims = {
      at_least("learned_correlation", "6.7: at least as correlated with the teacher as supervised",
               measured[0].correlation, measured[1].correlation),
      below("learned_worst_spike", "6.15: its worst spike is smaller than the supervised one's",
            measured[0].worst_spike, measured[1].worst_spike)};
  return result;
}

}  // namespace pacer
