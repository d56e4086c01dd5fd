#include "core/files/rules/rules_json.hpp"

namespace forefront {

namespace {

constexpr std::size_t kMaxRulesBytes = std::size_t{1} << 20;

double readValue(const JsonValue &value, FrontRule rule, JsonCheck &check) {
    const std::string what = inQuotes(wordOf(rule));
    switch (frontRuleInfo(rule).kind) {
    case RuleKind::Choice:
        return static_cast<double>(check.choice(value, wordsOf<BaseRule>(), what));
    case RuleKind::Switch:
        return check.flag(value, what) ? 1.0 : 0.0;
    case RuleKind::Number:
    case RuleKind::Whole:
        break;
    }
    return check.number(value, what);
}

void refuseUnknown(const JsonValue &object, JsonCheck &check) {
    for (auto member = object.begin(); member != object.end(); ++member) {
        if (!fromWord<FrontRule>(member.key())) {
            check.fault(member.keyValue(), "unknown-rule",
                        "unknown rule " + inQuotes(member.key()) + "; expected " + wordList<FrontRule>());
        }
    }
}

} // namespace

FrontRules readRules(const JsonValue &object, JsonCheck &check) {
    FrontRules rules;
    if (!check.expect(object, JsonKind::Object, "the rules")) {
        return rules;
    }
    refuseUnknown(object, check);
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        const auto given = object.find(wordOf(rule));
        if (!given) {
            continue;
        }
        const std::size_t before = check.faults().size();
        const double value = readValue(*given, rule, check);
        if (check.faults().size() > before) {
            continue;
        }
        if (const std::string fault = frontRuleFault(rule, value); !fault.empty()) {
            check.fault(*given, "bad-number", inQuotes(wordOf(rule)) + ": " + fault);
        } else {
            setValue(rules, rule, value);
        }
    }
    return rules;
}

Result<FrontRules> readRulesText(const SourceText &source) {
    const Result<JsonDocument> document = JsonDocument::parse(source);
    if (!document) {
        return document.faults();
    }
    JsonCheck check(source);
    check.refuseRepeats(document->root());
    const FrontRules rules = readRules(document->root(), check);
    if (!check.faults().empty()) {
        return check.faults();
    }
    return rules;
}

Result<FrontRules> readRulesFile(const std::filesystem::path &path) {
    const Result<std::string> text = readRegularFile(path, kMaxRulesBytes);
    if (!text) {
        return text.faults();
    }
    SourceText source;
    source.text = *text;
    source.name = path.string();
    return readRulesText(source);
}

void writeRules(const FrontRules &rules, JsonText &out) {
    out << '{';
    out.list(changedRules(rules), ", ", [&](FrontRule rule) {
        out << '"' << wordOf(rule) << "\": ";
        switch (frontRuleInfo(rule).kind) {
        case RuleKind::Choice:
            out << '"' << wordOf(rules.base) << '"';
            break;
        case RuleKind::Switch:
            out << (valueOf(rules, rule) != 0.0 ? "true" : "false");
            break;
        case RuleKind::Number:
        case RuleKind::Whole:
            out.number(valueOf(rules, rule));
            break;
        }
    });
    out << '}';
}

void writeRules(const FrontRules &rules, JsonWriter &json) {
    json.beginObject();
    for (const FrontRule rule : changedRules(rules)) {
        json.key(wordOf(rule));
        switch (frontRuleInfo(rule).kind) {
        case RuleKind::Choice:
            json.value(wordOf(rules.base));
            break;
        case RuleKind::Switch:
            json.value(valueOf(rules, rule) != 0.0);
            break;
        case RuleKind::Number:
        case RuleKind::Whole:
            json.value(valueOf(rules, rule));
            break;
        }
    }
    json.endObject();
}

} // namespace forefront
