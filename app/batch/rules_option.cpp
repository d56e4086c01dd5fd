#include "app/batch/rules_option.hpp"

#include "core/files/rules/rules_json.hpp"

namespace forefront {

void addRulesOption(CLI::App &app, std::optional<std::filesystem::path> &file) {
    app.add_option(
           "--rules", file,
           "rules of the classic method, such as {\"base\": \"oldest\", \"radius\": 2}, instead of those of the "
           "project; 'forefront rules' lists them")
        ->type_name("FILE.json");
}

Diagnostics applyRules(const std::optional<std::filesystem::path> &file, MeshingOptions &options) {
    if (!file) {
        return {};
    }
    if (options.elements != Elements::Triangles) {
        return error("unused-rules", "--rules: quadrilaterals have a front of their own, without these rules",
                     "leave out --rules, or add --elements triangles --method classic");
    }
    if (options.method != Method::Classic) {
        return error("unused-rules", "--rules: the fast method has no such rules", "add --method classic");
    }
    const Result<FrontRules> rules = readRulesFile(*file);
    if (!rules) {
        return rules.faults();
    }
    options.rules = *rules;
    return {};
}

} // namespace forefront
