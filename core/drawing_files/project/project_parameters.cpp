#include "core/drawing_files/project/project_parameters.hpp"

#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/base/number_text.hpp"

#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Reads a number or a string.
std::string readExpression(const JsonValue &value, JsonCheck &check, const std::string &what) {
    return value.is(JsonKind::Number) ? exactText(check.number(value, what)) : check.string(value, what);
}

/// Reports the faults of the parameters at their names or expressions, but not those that follow from others, and only
/// the first of those that are too many. Parameters may use each other in any order.
void checkParameters(const JsonValue &object, const Document &document, JsonCheck &check) {
    const std::vector<ParameterState> states = parameterStates(document.parameters);
    std::size_t k = 0;
    for (auto entry = object.begin(); entry != object.end() && k <= kMaxParameters && !check.full(); ++entry, ++k) {
        if (!states[k].value && !states[k].follows) {
            check.fault(states[k].faultyName ? entry.keyValue() : *entry, "bad-parameter",
                        "parameter '" + document.parameters[k].name + "': " + states[k].fault);
        }
    }
}

/// Replaces the expressions of some parameters. Their faults are not the file's, but are reported at its start.
void overrideAll(const JsonValue &root, const std::map<std::string, std::string> &overrides, Document &document,
                 JsonCheck &check) {
    Document plain = document;
    plain.formulas.clear(); // they are applied later, where faults are reported at their lines
    const Result<Document> next = overrideParameters(plain, overrides);
    if (!next) {
        check.fault(root, next.faults().front().code, next.faults().front().message, next.faults().front().advice);
        return;
    }
    document.parameters = next->parameters;
    document.spacing.names = next->spacing.names;
}

void readFormulas(const JsonValue &object, Document &document, JsonCheck &check) {
    for (auto entry = object.begin(); entry != object.end() && !check.full(); ++entry) {
        const std::optional<NumberAddress> address = parseAddress(entry.key());
        if (!address || !readNumber(document, *address)) {
            check.fault(entry.keyValue(), "bad-formula", "no number has the address " + inQuotes(entry.key()));
            continue;
        }
        const std::string text = readExpression(*entry, check, "a formula");
        const Result<double> value = evaluateFormula(document, text);
        if (!value) {
            check.fault(*entry, "bad-formula", value.faults().front().message, value.faults().front().advice);
        }
        document.formulas[*address] = text;
    }
    if (!check.faults().empty()) {
        return;
    }
    NumberAddress failed;
    Result<Document> next = applyFormulas(document, &failed);
    if (next) {
        document = *std::move(next);
        return;
    }
    const Diagnostic &fault = next.faults().front();
    const std::string text = toString(failed);
    if (fault.code == "constraint-conflict") { // of several numbers together
        check.fault(object, fault.code, fault.message, fault.advice);
        return;
    }
    check.fault(object.find(text).value_or(object), fault.code, "formula for " + inQuotes(text) + ": " + fault.message,
                fault.advice);
}

} // namespace

void readParameters(const JsonValue &root, const std::map<std::string, std::string> &overrides, Document &document,
                    JsonCheck &check) {
    const auto parameters = root.find("parameters");
    if (parameters && check.expect(*parameters, JsonKind::Object, "\"parameters\"")) {
        for (auto entry = parameters->begin(); entry != parameters->end() && !check.full(); ++entry) {
            document.parameters.push_back(
                {entry.key(), readExpression(*entry, check, "the expression of a parameter")});
        }
        if (check.faults().empty()) {
            checkParameters(*parameters, document, check);
        }
    }
    document.spacing.names = parameterValues(document.parameters);
    if (!overrides.empty() && check.faults().empty()) {
        overrideAll(parameters.value_or(root), overrides, document, check);
    }
    const auto formulas = root.find("formulas");
    if (check.faults().empty() && formulas && check.expect(*formulas, JsonKind::Object, "\"formulas\"")) {
        readFormulas(*formulas, document, check);
    }
}

} // namespace forefront
