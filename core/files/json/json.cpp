#include "core/files/json/json.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace forefront {

namespace {

constexpr std::size_t kDeepest = 64;
constexpr char kRecordSeparator = '\x1e';

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

int hexDigit(char c) {
    if (isDigit(c)) {
        return c - '0';
    }
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

void appendUtf8(std::string &text, std::uint32_t code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xc0 | (code >> 6));
        text += static_cast<char>(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        text += static_cast<char>(0xe0 | (code >> 12));
        text += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        text += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        text += static_cast<char>(0xf0 | (code >> 18));
        text += static_cast<char>(0x80 | ((code >> 12) & 0x3f));
        text += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        text += static_cast<char>(0x80 | (code & 0x3f));
    }
}

/// Returns the value of four hexadecimal digits at `at`, whose syntax has been checked.
std::uint32_t hexAt(std::string_view text, std::size_t at) {
    std::uint32_t code = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        code = code * 16 + static_cast<std::uint32_t>(hexDigit(text[at + k]));
    }
    return code;
}

} // namespace

/// A parser without recursion: the open containers are a stack of tape entries.
class JsonParser {
  public:
    /// `sequence`: the text holds one or more values.
    JsonParser(const SourceText &source, bool sequence) : source_(source), text_(source.text), sequence_(sequence) {}

    Result<JsonDocument> run() {
        document_.text_ = text_;
        if (text_.size() >= std::numeric_limits<std::uint32_t>::max()) {
            fail("too-large", "a JSON text of 4 GiB or more cannot be read");
            return faults_;
        }
        sequence_ ? readSequence() : readWhole();
        if (!faults_.empty()) {
            return faults_;
        }
        return std::move(document_);
    }

  private:
    void readWhole() {
        readValue();
        if (at_ < text_.size()) {
            expected("the end of the file");
        }
    }

    /// Reads values one after the other into an array. After the first one, each must be an object.
    void readSequence() {
        const std::uint32_t all = push(JsonKind::Array);
        do {
            readValue();
            skipSeparators();
        } while (at_ < text_.size() && text_[at_] == '{' && faults_.empty());
        close(all);
        if (at_ < text_.size()) {
            expected("the end of the file");
        }
    }

    /// Reads one value with all that it contains, and the blanks around it.
    void readValue() {
        skipSeparators();
        while (faults_.empty()) {
            if (value() && afterValue()) {
                break;
            }
        }
    }

    void fail(std::string code, std::string message) {
        if (faults_.empty()) {
            faults_.push_back(faultAt(source_, at_, std::move(code), std::move(message)));
        }
    }
    void expected(const std::string &what) {
        fail("json-syntax", "expected " + what +
                                (at_ < text_.size() ? ", found " + inQuotes(text_.substr(at_, 1))
                                                    : std::string(", found the end of the file")));
    }

    void skipBlanks() {
        while (at_ < text_.size() &&
               (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t' || text_[at_] == '\r')) {
            ++at_;
        }
    }
    /// Skips blanks and the record separators of RFC 8142.
    void skipSeparators() {
        skipBlanks();
        while (sequence_ && take(kRecordSeparator)) {
            skipBlanks();
        }
    }
    bool take(char c) {
        if (at_ < text_.size() && text_[at_] == c) {
            ++at_;
            return true;
        }
        return false;
    }
    std::uint32_t push(JsonKind kind) {
        document_.tape_.push_back({at_, 0, kind});
        return static_cast<std::uint32_t>(document_.tape_.size() - 1);
    }
    void close(std::uint32_t entry) {
        document_.tape_[entry].next = static_cast<std::uint32_t>(document_.tape_.size());
    }

    /// Reads a value or opens a container. Returns false if it opened a container that is not empty.
    bool value() {
        skipBlanks();
        const char c = at_ < text_.size() ? text_[at_] : '\0';
        if (c == '{' || c == '[') {
            return !open(c == '{' ? JsonKind::Object : JsonKind::Array);
        }
        if (c == '"') {
            close(push(JsonKind::String));
            string();
        } else if (c == '-' || isDigit(c)) {
            close(push(JsonKind::Number));
            number();
        } else {
            word();
        }
        return true;
    }

    bool open(JsonKind kind) {
        if (open_.size() == kDeepest) {
            fail("too-deep", "more than " + std::to_string(kDeepest) + " levels of nesting");
            return false;
        }
        const std::uint32_t entry = push(kind);
        ++at_;
        skipBlanks();
        if (take(kind == JsonKind::Object ? '}' : ']')) {
            close(entry);
            return false;
        }
        open_.push_back(entry);
        if (kind == JsonKind::Object) {
            key();
        }
        return true;
    }

    void key() {
        skipBlanks();
        if (at_ >= text_.size() || text_[at_] != '"') {
            expected("a name in double quotes");
            return;
        }
        close(push(JsonKind::String));
        string();
        skipBlanks();
        if (!take(':')) {
            expected("':'");
        }
    }

    /// Closes the containers that end here. Returns true at the end of the outermost value.
    bool afterValue() {
        while (faults_.empty()) {
            skipBlanks();
            if (open_.empty()) {
                return true;
            }
            const bool object = document_.tape_[open_.back()].kind == JsonKind::Object;
            if (take(',')) {
                if (object) {
                    key();
                }
                return false;
            }
            if (!take(object ? '}' : ']')) {
                expected(object ? "',' or '}'" : "',' or ']'");
                return false;
            }
            close(open_.back());
            open_.pop_back();
        }
        return false;
    }

    void word() {
        const auto matches = [&](std::string_view name, JsonKind kind) {
            if (text_.substr(at_, name.size()) != name) {
                return false;
            }
            close(push(kind));
            at_ += name.size();
            return true;
        };
        if (!matches("true", JsonKind::True) && !matches("false", JsonKind::False) &&
            !matches("null", JsonKind::Null)) {
            expected("a value");
        }
    }

    bool digits() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && isDigit(text_[at_])) {
            ++at_;
        }
        return at_ > begin;
    }

    void number() {
        take('-');
        if (!take('0') && !digits()) {
            expected("a digit");
            return;
        }
        if (take('.') && !digits()) {
            expected("a digit after the decimal point");
            return;
        }
        if (take('e') || take('E')) {
            if (!take('+')) {
                take('-');
            }
            if (!digits()) {
                expected("a digit of the exponent");
            }
        }
    }

    void string() {
        ++at_;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"') {
                ++at_;
                return;
            }
            if (static_cast<unsigned char>(c) < 0x20) {
                fail("json-syntax", "unescaped control character in a string");
                return;
            }
            ++at_;
            if (c == '\\' && !escape()) {
                return;
            }
        }
        expected("the closing double quote of a string");
    }

    bool escape() {
        const char c = at_ < text_.size() ? text_[at_] : '\0';
        if (c == 'u') {
            ++at_;
            for (int k = 0; k < 4; ++k, ++at_) {
                if (at_ >= text_.size() || hexDigit(text_[at_]) < 0) {
                    expected("four hexadecimal digits");
                    return false;
                }
            }
            return true;
        }
        if (c == '\0' || std::string_view("\"\\/bfnrt").find(c) == std::string_view::npos) {
            expected("one of \"\\/bfnrtu after a backslash");
            return false;
        }
        ++at_;
        return true;
    }

    const SourceText &source_;
    std::string_view text_;
    bool sequence_;
    std::size_t at_ = 0;
    JsonDocument document_;
    std::vector<std::uint32_t> open_;
    Diagnostics faults_;
};

Result<JsonDocument> JsonDocument::parse(const SourceText &source) {
    return JsonParser(source, false).run();
}

Result<JsonDocument> JsonDocument::parseSequence(const SourceText &source) {
    return JsonParser(source, true).run();
}

std::size_t JsonValue::count() const {
    std::size_t number = 0;
    for (auto item = begin(); item != end(); ++item) {
        ++number;
    }
    return number;
}

std::optional<JsonValue> JsonValue::find(std::string_view name) const {
    if (is(JsonKind::Object)) {
        for (auto member = begin(); member != end(); ++member) {
            if (member.key() == name) {
                return *member;
            }
        }
    }
    return std::nullopt;
}

std::optional<double> JsonValue::number() const {
    if (!is(JsonKind::Number)) {
        return std::nullopt;
    }
    const std::string_view text = document_->text_.substr(offset());
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem == std::errc{} && std::isfinite(value)) {
        return value;
    }
    // from_chars reports numbers too small for a double as out of range, too.
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.data()));
    const std::size_t exponent = digits.find_first_of("eE");
    const bool tiny = problem == std::errc::result_out_of_range && exponent != std::string_view::npos &&
                      exponent + 1 < digits.size() && digits[exponent + 1] == '-';
    return tiny ? std::optional<double>(0.0) : std::nullopt;
}

std::optional<std::int64_t> JsonValue::integer() const {
    if (!is(JsonKind::Number)) {
        return std::nullopt;
    }
    const std::string_view text = document_->text_.substr(offset());
    std::int64_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool more = end != text.data() + text.size() && (*end == '.' || *end == 'e' || *end == 'E');
    return problem == std::errc{} && !more ? std::optional<std::int64_t>(value) : std::nullopt;
}

std::string_view JsonValue::numeral() const {
    if (!is(JsonKind::Number)) {
        return {};
    }
    const std::string_view text = document_->text_.substr(offset());
    return text.substr(0, text.find_first_not_of("+-.0123456789eE"));
}

std::string JsonValue::string() const {
    std::string result;
    if (!is(JsonKind::String)) {
        return result;
    }
    const std::string_view text = document_->text_;
    for (std::size_t at = offset() + 1; text[at] != '"'; ++at) {
        if (text[at] != '\\') {
            result += text[at];
            continue;
        }
        const char c = text[++at];
        if (c != 'u') {
            constexpr std::string_view kLetters = "\"\\/bfnrt";
            constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
            result += kMeanings[kLetters.find(c)];
            continue;
        }
        std::uint32_t code = hexAt(text, at + 1);
        at += 4;
        if (code >= 0xd800 && code < 0xdc00 && text.substr(at + 1, 2) == "\\u") {
            const std::uint32_t low = hexAt(text, at + 3);
            if (low >= 0xdc00 && low < 0xe000) {
                code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
                at += 6;
            }
        }
        appendUtf8(result, code >= 0xd800 && code < 0xe000 ? 0xfffd : code);
    }
    return result;
}

std::string jsonString(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            constexpr std::string_view kHex = "0123456789abcdef";
            result += "\\u00";
            result += kHex[static_cast<unsigned char>(c) >> 4];
            result += kHex[static_cast<unsigned char>(c) & 15U];
        } else {
            result += c;
        }
    }
    result += '"';
    return result;
}

} // namespace forefront
