#pragma once

#include "core/engine/mesher/front_rules.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"
#include "core/files/json/json_writer.hpp"

#include <filesystem>

namespace forefront {

/// Reads the members of "rules" in a project, a lesson or a file of rules; those that are missing are the defaults.
/// Unknown members and values out of bounds are faults.
FrontRules readRules(const JsonValue &object, JsonCheck &check);
/// Reads a file of rules: an object with the members of "rules". Faults: those of reading, of JSON and of readRules().
Result<FrontRules> readRulesText(const SourceText &source);
Result<FrontRules> readRulesFile(const std::filesystem::path &path);

/// Writes the rules that differ from their defaults as an object.
void writeRules(const FrontRules &rules, JsonText &out);
void writeRules(const FrontRules &rules, JsonWriter &json);

} // namespace forefront
