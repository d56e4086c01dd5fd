#pragma once

#include "core/files/json/json.hpp"
#include "core/files/text/text_writer.hpp"

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

/// Builds a JSON text value by value. Doubles get the fewest digits that read back to the same bits; those that JSON
/// cannot hold become null. Bytes of strings that are not UTF-8 are replaced.
class JsonWriter {
  public:
    enum class Layout : bool { OneLine, Indented };

    explicit JsonWriter(Layout layout) : layout_(layout), out_(sink_) {}

    JsonWriter &beginObject() { return open('{'); }
    JsonWriter &endObject() { return close('}'); }
    JsonWriter &beginArray() { return open('['); }
    JsonWriter &endArray() { return close(']'); }
    /// Begins a member of an object; its value follows.
    JsonWriter &key(std::string_view name);
    JsonWriter &value(std::string_view text);
    JsonWriter &value(const char *text) { return value(std::string_view(text)); }
    JsonWriter &value(double number);
    template <std::same_as<bool> Flag>
    JsonWriter &value(Flag flag) {
        begin();
        out_ << (flag ? "true" : "false");
        return *this;
    }
    template <std::integral Integer>
    requires(!std::same_as<Integer, bool>) JsonWriter &value(Integer number) {
        begin();
        out_ << number;
        return *this;
    }
    template <class Value>
    JsonWriter &member(std::string_view name, const Value &content) {
        return key(name).value(content);
    }
    /// Writes an array of plain values in one line.
    template <class Range>
    JsonWriter &values(const Range &range) {
        beginArray();
        const Layout layout = std::exchange(layout_, Layout::OneLine);
        for (const auto &item : range) {
            value(item);
        }
        endArray();
        layout_ = layout;
        return *this;
    }

    /// Returns the text with a line break at its end. The writer is then used up.
    std::string text();

  private:
    JsonWriter &open(char bracket);
    JsonWriter &close(char bracket);
    /// Puts a comma and a line break before a value or key where they belong.
    void begin();
    void breakLine();

    Layout layout_;
    StringSink sink_;
    TextWriter out_;
    std::size_t depth_ = 0;
    bool first_ = true;     ///< nothing is in the innermost object or array yet
    bool afterKey_ = false; ///< the value of a member follows
};

} // namespace forefront
