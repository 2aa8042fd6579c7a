// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pacer::tracking {

/// How linear predictors are learnt (3.1.3).
struct PredictorConfig {
  int support_pixels = 150;      ///< k, intensities that a predictor looks at
  int samples = 100;             ///< N, synthetic displacements it learns from; may be fewer than k
  double support_range = 20.0;   ///< r_sp, pixels; the support lies in a disc of this radius
  double training_range = 30.0;  ///< r_tr, pixels; displacements go as far across and down
  double ridge = 1e-2;           ///< added to the Gram matrix, relative to its mean diagonal

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("support_pixels", support_pixels);
    visit("samples", samples);
    visit("support_range", support_range);
    visit("training_range", training_range);
    visit("ridge", ridge);
  }
};

/// How a template is registered (3.1.1).
struct RegistrationConfig {
  int most_steps = 50;    ///< Levenberg-Marquardt's, taken or not
  double damping = 1e-3;  ///< at first, relative to the Hessian's diagonal

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("most_steps", most_steps);
    visit("damping", damping);
  }
};

/// Greedy clustering of templates (4.2.1).
struct SmatConfig {
  int components = 4;          ///< M, at most
  int templates = 60;          ///< n, in a component at most
  double learning_rate = 0.2;  ///< alpha, how fast the components' ranks change

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("components", components);
    visit("templates", templates);
    visit("learning_rate", learning_rate);
  }
};

/// Clustering of templates by medoidshift (4.2.2).
struct MedoidshiftConfig {
  int templates = 200;    ///< M, at most; the oldest leaves
  int fewest = 12;        ///< before frame 11 of tracking all templates are one cluster
  double quantile = 0.5;  ///< of the distances: the kernel's bandwidth

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("templates", templates);
    visit("fewest", fewest);
    visit("quantile", quantile);
  }
};

/// Everything that the thesis's trackers are set by: Table 4.2, and beside it what the text says in
/// passing or leaves open (docs/design/tracking.md). One set for every sequence.
struct TrackingConfig {
  PredictorConfig predictor;
  RegistrationConfig registration;
  SmatConfig smat;
  MedoidshiftConfig medoidshift;
  int template_pixels = 1024;     ///< of a template at most: larger targets are sampled on a grid
  int registered_pixels = 16384;  ///< likewise where templates are registered
  int flock_predictors = 60;      ///< LP-FLOCK's
  int smat_predictors = 160;      ///< L, LP-SMAT's, shared out among the components
  int med_predictors = 80;        ///< L, LP-MED's
  double forgetting = 0.1;        ///< beta, of predictors' errors

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("predictor", predictor);
    visit("registration", registration);
    visit("smat", smat);
    visit("medoidshift", medoidshift);
    visit("template_pixels", template_pixels);
    visit("registered_pixels", registered_pixels);
    visit("flock_predictors", flock_predictors);
    visit("smat_predictors", smat_predictors);
    visit("med_predictors", med_predictors);
    visit("forgetting", forgetting);
  }
};

}  // namespace pacer::tracking
