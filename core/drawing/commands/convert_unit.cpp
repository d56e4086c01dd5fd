#include "core/drawing/commands/convert_unit.hpp"

#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

/// Returns the text of the length of one unit in another: "25.4", "1/25.4" or "0.001".
std::string lengthOf(LengthUnit unit, LengthUnit in) {
    const double there = *conversion(unit, in), back = *conversion(in, unit);
    const std::string whole = exactText(there), ratio = "1/" + exactText(back);
    return there < 1.0 && 1.0 / back == there && ratio.size() < whole.size() ? ratio : whole;
}

bool uses(const std::string &text, std::string_view name) {
    const std::vector<std::string_view> names = namesIn(text);
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns the factor that a formula of a length or an area has for a unit.
std::string factorOf(const std::string &name, int power) {
    return '*' + name + (power == 2 ? "^2" : "");
}

/// Returns true if an expression can be a factor as it stands: a name, a number, a call, a product, or all of it in
/// parentheses.
bool isFactor(std::string_view text) {
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (depth == 0 && std::string_view("+-?:<>=!&|%").find(c) != std::string_view::npos) {
            return false;
        }
    }
    return true;
}

/// Returns the expression within parentheses that enclose all of it; the expression if none do.
std::string withoutParentheses(const std::string &text) {
    int depth = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        depth += text[k] == '(' ? 1 : text[k] == ')' ? -1 : 0;
        if (depth == 0 && k + 1 < text.size()) {
            return text;
        }
    }
    return text.starts_with('(') && text.ends_with(')') ? text.substr(1, text.size() - 2) : text;
}

/// Returns what a formula multiplies by the factor of a unit, if it was given that factor by multiplied().
std::optional<std::string> multiplicand(const std::string &text, const std::string &factor) {
    if (!text.ends_with(factor)) {
        return std::nullopt;
    }
    const std::string rest = text.substr(0, text.size() - factor.size());
    return isFactor(rest) ? std::optional(rest) : std::nullopt;
}

std::string multiplied(const std::string &text, const std::string &factor) {
    return (isFactor(text) ? text : '(' + text + ')') + factor;
}

/// Carries the formulas of a document through a change of its unit.
class UnitChange {
  public:
    UnitChange(const Document &document, LengthUnit to) : document_(document), to_(to) {
        for (const LengthUnit unit : valuesOf<LengthUnit>()) {
            if (unit == document.unit || unit == LengthUnit::None) {
                continue;
            }
            const std::string name = unitParameter(document, unit);
            if (isParameter(name) && isOnlyFactor(name)) {
                factors_.emplace(unit, name);
            }
        }
    }

    /// Sets the formulas and the parameters of the document in its new unit.
    Status apply(Document &next) {
        next.formulas.clear();
        for (const auto &[address, text] : document_.formulas) {
            next.formulas[address] = carried(text, lengthPower(document_, address));
        }
        for (const auto &[unit, name] : factors_) {
            const std::size_t index = parameterIndex(next.parameters, name);
            if (unit == to_) {
                next.parameters.erase(next.parameters.begin() + static_cast<std::ptrdiff_t>(index));
            } else {
                next.parameters[index].expression = lengthOf(unit, to_);
            }
        }
        if (added_) {
            next.parameters.push_back({unitParameter(document_, document_.unit), lengthOf(document_.unit, to_)});
        }
        if (next.parameters.size() > kMaxParameters) {
            return error("bad-parameter", "the formulas need one more parameter than " + std::to_string(kMaxParameters),
                         "remove a parameter that is not used");
        }
        next.spacing.names = parameterValues(next.parameters);
        pruneFormulas(next);
        return {};
    }

  private:
    bool isParameter(const std::string &name) const {
        return parameterIndex(document_.parameters, name) < document_.parameters.size();
    }

    /// Returns true if a parameter is used for nothing but as the last factor of formulas without other units.
    bool isOnlyFactor(const std::string &name) const {
        const auto &parameters = document_.parameters;
        const auto &spacing = document_.spacing.expression;
        const bool elsewhere =
            (spacing && uses(*spacing, name)) ||
            std::any_of(parameters.begin(), parameters.end(), [&](const auto &p) { return uses(p.expression, name); });
        return !elsewhere &&
               std::all_of(document_.formulas.begin(), document_.formulas.end(), [&](const auto &formula) {
                   const int power = lengthPower(document_, formula.first);
                   const auto rest = power == 0 ? std::nullopt : multiplicand(formula.second, factorOf(name, power));
                   return !uses(formula.second, name) || (rest && !namesUnit(*rest));
               });
    }

    bool namesUnit(const std::string &text) const {
        const auto units = valuesOf<LengthUnit>();
        return std::any_of(units.begin(), units.end(), [&](LengthUnit unit) {
            return unit != LengthUnit::None && uses(text, unitParameter(document_, unit));
        });
    }

    std::string carried(const std::string &text, int power) {
        if (power == 0) {
            return text;
        }
        for (const auto &[unit, name] : factors_) {
            if (const auto rest = multiplicand(text, factorOf(name, power)); rest && uses(text, name)) {
                return unit == to_ ? withoutParentheses(*rest) : text;
            }
        }
        added_ = true;
        return multiplied(text, factorOf(unitParameter(document_, document_.unit), power));
    }

    const Document &document_;
    LengthUnit to_;
    std::map<LengthUnit, std::string> factors_; ///< parameters whose values change with the unit
    bool added_ = false;                        ///< some formula is multiplied by the unit before
};

} // namespace

std::string unitParameter(const Document &document, LengthUnit unit) {
    const std::string word(wordOf(unit));
    std::set<std::string> taken = namesOf(document.parameters);
    const std::optional<double> size = conversion(unit, document.unit);
    const NamedValues values = parameterValues(document.parameters);
    for (const std::string &name : {word, "unit_" + word}) {
        const auto value = values.find(name);
        const bool same = size && unit != document.unit && value != values.end() && value->second == *size;
        if (same || (!taken.contains(name) && !isReservedName(name))) {
            return name;
        }
    }
    return freeParameterName("unit_" + word + '_', 2, taken);
}

Result<Document> convertUnit(const Document &document, LengthUnit unit) {
    const std::optional<double> factor = conversion(document.unit, unit);
    if (!factor || unit == document.unit) {
        Document next = document;
        next.unit = unit;
        return next;
    }
    Result<Document> scaled = scaleDocument(document, {}, *factor);
    if (!scaled) {
        return scaled;
    }
    Document next = *std::move(scaled);
    next.unit = unit;
    if (Status faults = UnitChange(document, unit).apply(next); !faults.empty()) {
        return faults;
    }
    return next;
}

} // namespace forefront
