// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studies/study.h"

namespace pacer {

// One function for each study, each in a file of its own.
StudyResult study_absence(const StudyContext& context, report::Page& page);
StudyResult study_action_clusters(const StudyContext& context, report::Page& page);
StudyResult study_apriori(const StudyContext& context, report::Page& page);
StudyResult study_balloon(const StudyContext& context, report::Page& page);
StudyResult study_blobs(const StudyContext& context, report::Page& page);
StudyResult study_convergence(const StudyContext& context, report::Page& page);
StudyResult study_demonstrations(const StudyContext& context, report::Page& page);
StudyResult study_exemplar_scale(const StudyContext& context, report::Page& page);
StudyResult study_following(const StudyContext& context, report::Page& page);
StudyResult study_generalisation(const StudyContext& context, report::Page& page);
StudyResult study_hits(const StudyContext& context, report::Page& page);
StudyResult study_interframe(const StudyContext& context, report::Page& page);
StudyResult study_lag(const StudyContext& context, report::Page& page);
StudyResult study_learning_curve(const StudyContext& context, report::Page& page);
StudyResult study_loss(const StudyContext& context, report::Page& page);
StudyResult study_output_clustering(const StudyContext& context, report::Page& page);
StudyResult study_parameters(const StudyContext& context, report::Page& page);
StudyResult study_perceptual_weighting(const StudyContext& context, report::Page& page);
StudyResult study_recall_efficiency(const StudyContext& context, report::Page& page);
StudyResult study_response(const StudyContext& context, report::Page& page);
StudyResult study_signals(const StudyContext& context, report::Page& page);
StudyResult study_tasks(const StudyContext& context, report::Page& page);
StudyResult study_standing_lead(const StudyContext& context, report::Page& page);
StudyResult study_throughput(const StudyContext& context, report::Page& page);
StudyResult study_tracking(const StudyContext& context, report::Page& page);
StudyResult study_training_range(const StudyContext& context, report::Page& page);
StudyResult study_transfer(const StudyContext& context, report::Page& page);
StudyResult study_weighting(const StudyContext& context, report::Page& page);

}  // namespace pacer
