#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace forefront {
namespace {

/// Returns true if the text is a valid name in formulas: a letter or _, then letters, digits and _.
bool isName(const std::string &text) {
    const std::vector<std::string_view> names = namesIn(text);
    return names.size() == 1 && names.front().size() == text.size();
}

/// Returns the names that an expression depends on; none if it is too long to evaluate.
std::vector<std::string_view> dependencies(const Parameter &parameter) {
    return parameter.expression.size() <= kMaxExpressionLength ? namesIn(parameter.expression)
                                                               : std::vector<std::string_view>();
}

/// Evaluates parameters in the order in which they depend on each other.
class Evaluation {
  public:
    explicit Evaluation(const std::vector<Parameter> &parameters)
        : parameters_(parameters), states_(parameters.size()), marks_(parameters.size(), Mark::New) {}

    std::vector<ParameterState> run() {
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
            states_[k].fault = nameFault(k);
            states_[k].faultyName = !states_[k].fault.empty();
            marks_[k] = states_[k].faultyName ? Mark::Done : Mark::New;
        }
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
            visit(k);
        }
        return std::move(states_);
    }

    NamedValues takeValues() { return std::move(values_); }

  private:
    enum class Mark : std::uint8_t { New, Open, Done };

    /// Returns the fault of a name; records a valid one.
    std::string nameFault(std::size_t index) {
        const std::string &name = parameters_[index].name;
        if (index >= kMaxParameters) { // visit() calls itself along dependencies
            indices_.emplace(name, index);
            return "there are " + std::to_string(parameters_.size()) + " parameters; expected at most " +
                   std::to_string(kMaxParameters);
        }
        if (name.size() > kMaxParameterName) {
            return "the name has " + std::to_string(name.size()) + " characters; expected at most " +
                   std::to_string(kMaxParameterName);
        }
        if (!isName(name)) {
            return "invalid name '" + name + "'; expected a letter or _, then letters, digits and _";
        }
        if (isReservedName(name)) {
            return "the name '" + name + "' is a coordinate, a function or a constant; choose another name";
        }
        return indices_.emplace(name, index).second ? "" : "another parameter has the name '" + name + "'";
    }

    void visit(std::size_t index) {
        if (marks_[index] != Mark::New) {
            return;
        }
        marks_[index] = Mark::Open;
        path_.push_back(index);
        for (const std::string_view name : dependencies(parameters_[index])) {
            const auto known = indices_.find(name);
            if (known != indices_.end()) {
                marks_[known->second] == Mark::Open ? reportCycle(known->second) : visit(known->second);
            }
        }
        path_.pop_back();
        marks_[index] = Mark::Done;
        if (states_[index].fault.empty()) {
            evaluate(index);
        }
    }

    /// Gives the parameters of a cycle the same fault. Each call marks at least one parameter that had no fault, so the
    /// number of calls is limited even if all parameters name each other.
    void reportCycle(std::size_t first) {
        if (!states_[first].fault.empty() && !states_[path_.back()].fault.empty()) {
            return;
        }
        const auto begin = std::find(path_.begin(), path_.end(), first);
        const std::string fault = "depends on itself: " + chainFrom(begin) + parameters_[first].name;
        for (auto at = begin; at != path_.end(); ++at) {
            if (states_[*at].fault.empty()) {
                states_[*at].fault = fault;
            }
        }
    }

    /// Returns the names of the path from a position on, each with an arrow; only the first ones if there are many.
    std::string chainFrom(std::vector<std::size_t>::const_iterator begin) const {
        constexpr std::ptrdiff_t kShown = 5;
        const bool all = path_.end() - begin <= kShown;
        const auto end = all ? path_.end() : begin + kShown;
        std::string chain;
        for (auto at = begin; at != end; ++at) {
            chain += parameters_[*at].name + " \xe2\x86\x92 ";
        }
        return all ? chain : chain + "\xe2\x80\xa6 \xe2\x86\x92 ";
    }

    void evaluate(std::size_t index) {
        for (const std::string_view name : dependencies(parameters_[index])) {
            if (indices_.contains(name) && !values_.contains(name)) {
                states_[index].fault = "uses '" + std::string(name) + "', which has no value";
                states_[index].follows = true;
                return;
            }
        }
        const Result<double> value = evaluateExpression(parameters_[index].expression, values_);
        if (value) {
            states_[index].value = *value;
            values_.emplace(parameters_[index].name, *value);
        } else {
            states_[index].fault = value.faults().front().message;
        }
    }

    const std::vector<Parameter> &parameters_;
    std::vector<ParameterState> states_;
    std::vector<Mark> marks_;
    std::map<std::string_view, std::size_t> indices_; ///< of the parameters with valid names
    std::vector<std::size_t> path_;                   ///< of dependencies, from the first parameter visited
    NamedValues values_;                              ///< known so far
};

} // namespace

std::vector<ParameterState> parameterStates(const std::vector<Parameter> &parameters) {
    return Evaluation(parameters).run();
}

NamedValues parameterValues(const std::vector<Parameter> &parameters) {
    Evaluation evaluation(parameters);
    evaluation.run();
    return evaluation.takeValues();
}

std::size_t parameterIndex(const std::vector<Parameter> &parameters, std::string_view name) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const Parameter &parameter) { return parameter.name == name; });
    return static_cast<std::size_t>(found - parameters.begin());
}

std::string freeParameterName(const std::string &stem, std::size_t first, const std::set<std::string> &taken) {
    for (std::size_t number = first;; ++number) {
        const std::string digits = std::to_string(number);
        std::string name = stem.substr(0, kMaxParameterName - digits.size()) + digits;
        if (!taken.contains(name)) {
            return name;
        }
    }
}

std::set<std::string> namesOf(const std::vector<Parameter> &parameters) {
    std::set<std::string> names;
    for (const Parameter &parameter : parameters) {
        names.insert(parameter.name);
    }
    return names;
}

} // namespace forefront
