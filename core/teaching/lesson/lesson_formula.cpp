#include "core/teaching/lesson/lesson_formula.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

bool isLetter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isNamePart(char c) {
    return isLetter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Returns true if a text begins with a word that ends there.
bool beginsWith(std::string_view text, std::string_view word) {
    return text.starts_with(word) && (text.size() == word.size() || !isNamePart(text[word.size()]));
}

std::string valueName(std::size_t k) {
    return 'v' + std::to_string(k);
}

/// Translates a formula name by name.
class FormulaReader {
  public:
    FormulaReader(std::string_view text, const RandomNumbers &numbers) : rest_(text), numbers_(numbers) {
        result_.text = text;
    }

    LessonFormula read() {
        while (!rest_.empty()) {
            if (std::isdigit(static_cast<unsigned char>(rest_.front())) != 0 || rest_.front() == '.') {
                copyNumber();
            } else if (!isLetter(rest_.front())) {
                copy(1);
            } else if (!takeValue() && !takeRandom()) {
                copy(nameLength());
            }
        }
        return std::move(result_);
    }

  private:
    void copy(std::size_t count) {
        result_.formula += rest_.substr(0, count);
        rest_.remove_prefix(count);
    }
    std::size_t nameLength() const {
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), isNamePart);
        return static_cast<std::size_t>(end - rest_.begin());
    }
    /// Copies a number with its exponent, whose letter is no name.
    void copyNumber() {
        std::size_t end = 0;
        while (end < rest_.size() && (isNamePart(rest_[end]) || rest_[end] == '.')) {
            ++end;
        }
        copy(end);
    }
    /// Takes the longest value that the rest begins with.
    bool takeValue() {
        std::optional<LessonValue> found;
        for (const LessonValue value : valuesOf<LessonValue>()) {
            if (beginsWith(rest_, wordOf(value)) && (!found || wordOf(value).size() > wordOf(*found).size())) {
                found = value;
            }
        }
        if (!found) {
            return false;
        }
        rest_.remove_prefix(wordOf(*found).size());
        result_.formula += valueName(result_.values.size());
        result_.values.push_back(*found);
        return true;
    }
    bool takeRandom() {
        const auto longer = [](const auto *a, const auto &b) {
            return a == nullptr || b.first.size() > a->first.size();
        };
        const RandomNumbers::value_type *found = nullptr;
        for (const auto &number : numbers_) {
            if (beginsWith(rest_, number.first) && longer(found, number)) {
                found = &number;
            }
        }
        if (found == nullptr) {
            return false;
        }
        rest_.remove_prefix(found->first.size());
        result_.formula += '(' + std::to_string(found->second.value) + ')';
        return true;
    }

    std::string_view rest_;
    const RandomNumbers &numbers_;
    LessonFormula result_;
};

} // namespace

LessonFormula formulaOf(LessonValue value) {
    return {std::string(wordOf(value)), valueName(0), {value}};
}

LessonFormula formulaOf(double constant) {
    return {numberText(constant, 15), exactText(constant), {}};
}

Result<LessonFormula> readFormula(const std::string &text, const RandomNumbers &numbers) {
    LessonFormula formula = FormulaReader(text, numbers).read();
    NamedValues ones;
    for (std::size_t k = 0; k < formula.values.size(); ++k) {
        ones[valueName(k)] = 1.0;
    }
    const Result<double> tried = evaluateExpression(formula.formula, ones);
    if (!tried && tried.faults().front().code == "expression-syntax") {
        std::string names = wordList<LessonValue>();
        for (const auto &[name, number] : numbers) {
            names += ", " + name;
        }
        return error("bad-field",
                     "the formula " + inQuotes(text) + " cannot be read: " + tried.faults().front().message,
                     "expected numbers, operators and these names: " + names);
    }
    return formula;
}

std::optional<double> valueOf(const LessonFormula &formula, const LessonState &state) {
    NamedValues named;
    for (std::size_t k = 0; k < formula.values.size(); ++k) {
        const std::optional<double> value = valueOf(formula.values[k], state);
        if (!value) {
            return std::nullopt;
        }
        named[valueName(k)] = *value;
    }
    const Result<double> number = evaluateExpression(formula.formula, named);
    return number ? std::optional(*number) : std::nullopt;
}

} // namespace forefront
