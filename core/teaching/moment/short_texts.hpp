#pragma once

#include "core/engine/mesher/trace.hpp"

#include <string>

namespace forefront {

/// Returns a step in a few words, under the rules of a run: "Take shortest segment AB". `rules`: of the classic method;
/// null for the fast method.
std::string stepLine(Step step, const FrontRules *rules);
/// Returns the same for the two-coloured front: "Take a diagonal, else leg AB".
std::string squareStepLine(Step step);
/// Returns a verdict in at most two words, such as "behind AB"; "–" if the candidate was not tried.
const char *shortVerdict(Verdict verdict);
/// Returns what names a candidate in a list: the number of its node, "C", or of a square "row", "open" or "close".
std::string shortName(const CandidateTrace &candidate);

} // namespace forefront
