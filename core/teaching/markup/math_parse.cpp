#include "core/files/source/source.hpp"
#include "core/teaching/markup/math.hpp"
#include "core/teaching/markup/math_symbols.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr int kMaxDepth = 12;                  ///< of braces, brackets and commands within each other
constexpr std::size_t kMaxFormula = 1000;      ///< bytes
constexpr std::size_t kValueRoom = 30;         ///< bytes that the number of a value may add
constexpr int kValueDepth = 2;                 ///< braces that it may add, of a power of 10
constexpr std::string_view kFences = "()[]|."; ///< brackets after \left and \right; a point for none

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Returns the number of bytes of the character that begins with a byte.
std::size_t lengthOf(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0xc0 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

MathNode symbol(std::string_view text, MathRole role = MathRole::Ordinary, bool italic = false) {
    return {.kind = MathKind::Symbol, .role = role, .italic = italic, .text = std::string(text)};
}

MathNode around(MathKind kind, std::vector<MathNode> parts) {
    return {.kind = kind, .parts = std::move(parts)};
}

/// Reads a formula from its beginning. After a fault, every function returns nothing.
class MathParser {
  public:
    explicit MathParser(std::string_view text) : text_(text) {}

    Result<MathNode> read() {
        if (text_.size() + kValueRoom * valueCount() > kMaxFormula) {
            fail(std::min(kMaxFormula, text_.size()),
                 "the formula is longer than " + std::to_string(kMaxFormula) + " bytes", "divide it");
        } else if (text_.find_first_not_of(' ') == std::string_view::npos) {
            fail(0, "the formula is empty", "write \\$ for a dollar sign that begins no formula");
        }
        std::optional<MathNode> formula = faults_.empty() ? row() : std::nullopt;
        if (formula && at_ < text_.size()) {
            const bool right = text_[at_] == '\\';
            fail(at_, right ? "\\right without \\left" : "a closing brace without an opening one",
                 right ? "write \\left before the bracket that it closes" : "write \\} for a brace that is shown");
        }
        if (!faults_.empty()) {
            return faults_;
        }
        return *std::move(formula);
    }

  private:
    std::nullopt_t fail(std::size_t at, std::string message, std::string advice = {}) {
        if (faults_.empty()) {
            faults_ = error("bad-formula", std::move(message), std::move(advice));
            faults_.front().column = static_cast<int>(at) + 1;
        }
        return std::nullopt;
    }

    std::size_t valueCount() const {
        std::size_t count = 0;
        for (std::size_t at = text_.find("\\value"); at != std::string_view::npos; at = text_.find("\\value", at + 1)) {
            ++count;
        }
        return count;
    }

    void skipBlanks() { at_ = std::min(text_.find_first_not_of(' ', at_), text_.size()); }
    bool startsWith(std::string_view word) const { return text_.substr(at_).starts_with(word); }
    /// Returns true before the end of a row: a closing brace, or the bracket that an inner row ends with.
    bool atEndOfRow(char end) const {
        return at_ >= text_.size() || text_[at_] == '}' || (end != '\0' && text_[at_] == end) ||
               (startsWith("\\right") && (at_ + 6 >= text_.size() || !isLetter(text_[at_ + 6])));
    }

    /// Reads parts up to the end of a row, which is left. `end`: a character that also ends it.
    std::optional<MathNode> row(char end = '\0') {
        if (++depth_ > kMaxDepth) {
            return fail(at_, "the formula is nested more than " + std::to_string(kMaxDepth) + " deep", "simplify it");
        }
        MathNode row;
        for (skipBlanks(); !atEndOfRow(end); skipBlanks()) {
            std::optional<MathNode> part = withScripts();
            if (!part) {
                return std::nullopt;
            }
            row.parts.push_back(*std::move(part));
        }
        --depth_;
        return row;
    }

    /// Reads an argument in braces, such as that of \sqrt. `of`: its command.
    std::optional<MathNode> argument(std::string_view of) {
        skipBlanks();
        if (at_ >= text_.size() || text_[at_] != '{') {
            return fail(at_, "expected { after " + std::string(of), "write " + std::string(of) + "{...}");
        }
        return braces();
    }

    /// Reads {...}, which must not be empty.
    std::optional<MathNode> braces() {
        const std::size_t open = at_++;
        std::optional<MathNode> inner = row();
        if (!inner) {
            return std::nullopt;
        }
        if (at_ >= text_.size() || text_[at_] != '}') {
            return fail(open, "a brace is not closed", "write } after what belongs to it");
        }
        if (inner->parts.empty()) {
            return fail(open, "nothing between the braces");
        }
        ++at_;
        return inner;
    }

    std::optional<MathNode> withScripts() {
        if (text_[at_] == '^' || text_[at_] == '_') {
            return fail(at_, std::string(1, text_[at_]) + " has nothing before it",
                        "write what the index or exponent belongs to first");
        }
        std::optional<MathNode> base = atom();
        std::optional<MathNode> sub, super;
        for (skipBlanks(); base && at_ < text_.size() && (text_[at_] == '^' || text_[at_] == '_'); skipBlanks()) {
            std::optional<MathNode> &script = text_[at_] == '^' ? super : sub;
            if (script) {
                return fail(at_, std::string("a second ") + text_[at_] + " at the same place",
                            "put both into the braces of one");
            }
            script = this->script();
            if (!script) {
                return std::nullopt;
            }
        }
        if (!base || (!sub && !super)) {
            return base;
        }
        MathNode node{.kind = MathKind::Scripts, .sub = sub.has_value(), .super = super.has_value()};
        node.parts.push_back(*std::move(base));
        for (std::optional<MathNode> *const script : {&sub, &super}) {
            if (*script) {
                node.parts.push_back(**std::move(script));
            }
        }
        return node;
    }

    /// Reads ^ or _ and what follows: a single character or command, or braces.
    std::optional<MathNode> script() {
        const std::string mark(1, text_[at_++]);
        skipBlanks();
        if (at_ >= text_.size() || text_[at_] == '}' || text_[at_] == '^' || text_[at_] == '_') {
            return fail(at_, "expected an index or exponent after " + mark);
        }
        if (text_[at_] == '{') {
            return braces();
        }
        if (isDigit(text_[at_]) && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])) {
            return fail(at_, "a number of several digits after " + mark, "write it in braces: " + mark + "{12}");
        }
        return atom();
    }

    std::optional<MathNode> atom() {
        const char c = text_[at_];
        if (c == '{') {
            return braces();
        }
        if (c == '\\') {
            return command();
        }
        if (isLetter(c)) {
            return symbol(text_.substr(at_++, 1), MathRole::Ordinary, true);
        }
        if (isDigit(c)) {
            return number();
        }
        const std::string_view character = text_.substr(at_, lengthOf(c));
        const std::optional<MathSymbol> known = symbolOfCharacter(character);
        if (!known) {
            return fail(at_, "unknown character " + inQuotes(character) + " in a formula",
                        "write words as \\text{...}; assets/lessons/README.md lists the symbols");
        }
        at_ += character.size();
        return symbol(known->text, known->role);
    }

    /// Reads digits, with a point between them.
    std::optional<MathNode> number() {
        const std::size_t from = at_;
        while (at_ < text_.size() &&
               (isDigit(text_[at_]) || (text_[at_] == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])))) {
            ++at_;
        }
        return symbol(text_.substr(from, at_ - from));
    }

    std::optional<MathNode> command() {
        const std::size_t from = at_++;
        std::size_t end = at_;
        while (end < text_.size() && isLetter(text_[end])) {
            ++end;
        }
        end = end == at_ && at_ < text_.size() ? at_ + lengthOf(text_[at_]) : end;
        const std::string name(text_.substr(at_, end - at_));
        at_ = std::min(end, text_.size());
        if (const std::optional<MathSymbol> known = symbolOfCommand(name)) {
            return symbol(known->text, known->role);
        }
        if (const std::optional<double> room = roomOfCommand(name)) {
            return MathNode{.kind = MathKind::Space, .room = *room};
        }
        return structure(name, from);
    }

    /// Reads the rest of a command with arguments.
    std::optional<MathNode> structure(const std::string &name, std::size_t from) {
        if (name == "frac") {
            std::optional<MathNode> above = argument("\\frac");
            std::optional<MathNode> below = above ? argument("\\frac{...}") : std::nullopt;
            return below ? std::optional(around(MathKind::Fraction, {*std::move(above), *std::move(below)}))
                         : std::nullopt;
        }
        if (name == "sqrt") {
            return root();
        }
        if (name == "overline") {
            std::optional<MathNode> below = argument("\\overline");
            return below ? std::optional(around(MathKind::Overline, {*std::move(below)})) : std::nullopt;
        }
        if (name == "value" && depth_ + kValueDepth > kMaxDepth) {
            return fail(from, "the formula is nested too deep for a value", "simplify it");
        }
        if (name == "text" || name == "mathrm" || name == "value") {
            return words('\\' + name);
        }
        if (name == "left") {
            return fence(from);
        }
        return fail(from, "unknown command \\" + name + " in a formula",
                    "assets/lessons/README.md lists the commands; write words as \\text{...}");
    }

    std::optional<MathNode> root() {
        skipBlanks();
        std::optional<MathNode> degree;
        if (at_ < text_.size() && text_[at_] == '[') {
            const std::size_t open = at_++;
            degree = row(']');
            if (!degree) {
                return std::nullopt;
            }
            if (at_ >= text_.size() || text_[at_] != ']' || degree->parts.empty()) {
                return fail(open, "the degree of a root is not closed or empty", "write \\sqrt[3]{...}");
            }
            ++at_;
        }
        std::optional<MathNode> below = argument("\\sqrt");
        if (!below) {
            return std::nullopt;
        }
        MathNode node = around(MathKind::Root, {*std::move(below)});
        if (degree) {
            node.parts.push_back(*std::move(degree));
        }
        return node;
    }

    /// Reads the words of \text{...} as they are.
    std::optional<MathNode> words(const std::string &command) {
        const std::size_t close = text_.find('}', at_);
        if (at_ >= text_.size() || text_[at_] != '{') {
            return fail(at_, "expected { after " + command, "write " + command + "{...}");
        }
        if (close == std::string_view::npos) {
            return fail(at_, "a brace is not closed", "write } after what belongs to it");
        }
        const std::string_view inner = text_.substr(at_ + 1, close - at_ - 1);
        if (const std::size_t brace = inner.find('{'); inner.empty() || brace != std::string_view::npos) {
            return fail(at_, inner.empty() ? "nothing between the braces" : "braces within " + command);
        }
        at_ = close + 1;
        return symbol(inner);
    }

    std::optional<MathNode> fence(std::size_t from) {
        MathNode node{.kind = MathKind::Fence};
        if (!bracket(node.text)) {
            return fail(at_, "expected a bracket after \\left", "write one of ( ) [ ] | or a point for none");
        }
        std::optional<MathNode> inner = row();
        if (!inner) {
            return std::nullopt;
        }
        if (!startsWith("\\right")) {
            return fail(from, "\\left without \\right", "close it with \\right) or, with nothing, \\right.");
        }
        at_ += 6;
        if (!bracket(node.closing)) {
            return fail(at_, "expected a bracket after \\right", "write one of ( ) [ ] | or a point for none");
        }
        node.parts.push_back(*std::move(inner));
        return node;
    }

    bool bracket(std::string &to) {
        skipBlanks();
        if (at_ >= text_.size() || kFences.find(text_[at_]) == std::string_view::npos) {
            return false;
        }
        to = text_[at_] == '.' ? std::string() : std::string(1, text_[at_]);
        ++at_;
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    Diagnostics faults_;
};

} // namespace

Result<MathNode> parseMath(std::string_view text) {
    return MathParser(text).read();
}

} // namespace forefront
