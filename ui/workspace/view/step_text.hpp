#pragma once

#include "core/engine/mesher/front_rules.hpp"
#include "core/engine/session/snapshot.hpp"
#include "core/teaching/moment/moment.hpp"

#include <optional>
#include <string>

namespace forefront {

/// Returns the line of one of the ten steps, short enough for a column; that of the base and of the score follow the
/// rules. `rules`: null for the fast method.
std::string stepLine(Step step, const FrontRules *rules);

/// Returns the line of a step of the front of quadrilaterals.
std::string squareStepLine(Step step);

/// Returns the result of a step: "3 of 14 in 6 cells"; empty while unknown.
std::string stepFinding(const Moment &moment, Step step);

/// Returns the step that a run is at; none before the first run and between advances.
std::optional<Step> liveStep(const SessionSnapshot &run, const Moment &moment);

} // namespace forefront
