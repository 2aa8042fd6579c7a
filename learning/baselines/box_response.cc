// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/box_response.h"

#include <string>

#include "learning/config_text.h"

namespace pacer::baselines {

void BoxDriving::write(ByteWriter& out) const {
  action.write(out);
  LossConfig config = when_lost;
  ConfigTextWriter settings;
  config.fields(settings);
  out.text(settings.text());
}

BoxDriving BoxDriving::read(ByteReader& in) {
  BoxDriving driving;
  driving.action = BoxAction::read(in);
  const std::string settings = in.text();
  driving.when_lost.fields(ConfigTextReader(settings));
  driving.when_lost.validate();
  return driving;
}

Command BoxResponse::respond(const std::optional<Box>& box, const Frame& frame,
                             Annotations& annotations) {
  if (!box || !is_proper(*box)) {
    annotations.label = label_of(loss_.phase(frame.time));
    return loss_.act(frame.time);
  }
  const Command command = action_(*box);
  loss_.saw(frame.time, command, 0.5 * (frame.size.width - 1) - box->x);
  annotations.boxes.push_back({.low = {.x = static_cast<float>(box->x - 0.5 * box->width),
                                       .y = static_cast<float>(box->y - 0.5 * box->height)},
                               .high = {.x = static_cast<float>(box->x + 0.5 * box->width),
                                        .y = static_cast<float>(box->y + 0.5 * box->height)},
                               .tone = Tone::kTarget});
  return command;
}

}  // namespace pacer::baselines
