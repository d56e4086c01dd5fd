#include "core/files/json/json_outline.hpp"

#include <algorithm>
#include <cstddef>

namespace forefront {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\x1e\xef\xbb\xbf"; // with RFC 8142's separator and the byte order mark
constexpr std::size_t kMaxKeys = 64;

/// Steps through the top of an object. Beyond the end of the text there is nothing.
class OutlineScanner {
  public:
    explicit OutlineScanner(std::string_view text) : text_(text) {}

    bool take(char wanted) {
        skipBlanks();
        const bool found = at_ < text_.size() && text_[at_] == wanted;
        at_ += found ? 1 : 0;
        return found;
    }

    /// Returns true if a string comes next.
    bool atString() {
        skipBlanks();
        return at_ < text_.size() && text_[at_] == '"';
    }

    /// Returns what is between the quotes; empty if the string is cut off.
    std::string_view string() {
        const std::size_t begin = ++at_;
        for (; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\\') {
                ++at_;
            } else if (text_[at_] == '"') {
                return text_.substr(begin, at_++ - begin);
            }
        }
        return {};
    }

    /// Goes to the comma after a value, or to the bracket that closes its container.
    void skipValue() {
        for (std::size_t depth = 0; at_ < text_.size();) {
            const char next = text_[at_];
            if (next == '"') {
                string();
                continue;
            }
            const bool closes = next == '}' || next == ']';
            if (depth == 0 && (next == ',' || closes)) {
                return;
            }
            depth += next == '{' || next == '[' ? 1 : 0;
            depth -= closes ? 1 : 0;
            ++at_;
        }
    }

  private:
    void skipBlanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace

bool JsonOutline::has(std::string_view key) const {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

JsonOutline outlineOf(std::string_view text) {
    JsonOutline outline;
    OutlineScanner scanner(text);
    bool more = scanner.take('{');
    for (; more && scanner.atString(); more = scanner.take(',')) {
        const std::string_view key = scanner.string();
        if (!scanner.take(':')) {
            return outline;
        }
        if (key == "type" && scanner.atString()) {
            outline.type = scanner.string();
            return outline;
        }
        if (outline.keys.size() < kMaxKeys) {
            outline.keys.push_back(key);
        }
        scanner.skipValue();
    }
    outline.ends = scanner.take('}');
    return outline;
}

bool beginsAsObject(std::string_view text) {
    return OutlineScanner(text).take('{');
}

} // namespace forefront
