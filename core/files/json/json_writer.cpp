#include "core/files/json/json_writer.hpp"

#include "core/files/common/names.hpp"

#include <cmath>
#include <utility>

namespace forefront {

JsonWriter &JsonWriter::key(std::string_view name) {
    begin();
    out_ << jsonString(validUtf8(name)) << (layout_ == Layout::Indented ? ": " : ":");
    afterKey_ = true;
    return *this;
}

JsonWriter &JsonWriter::value(std::string_view text) {
    begin();
    out_ << jsonString(validUtf8(text));
    return *this;
}

JsonWriter &JsonWriter::value(double number) {
    begin();
    if (std::isfinite(number)) {
        out_ << number;
    } else {
        out_ << "null";
    }
    return *this;
}

JsonWriter &JsonWriter::open(char bracket) {
    begin();
    out_ << bracket;
    ++depth_;
    first_ = true;
    return *this;
}

JsonWriter &JsonWriter::close(char bracket) {
    --depth_;
    if (!first_) {
        breakLine();
    }
    out_ << bracket;
    first_ = false;
    return *this;
}

void JsonWriter::begin() {
    if (std::exchange(afterKey_, false)) {
        return;
    }
    if (!first_) {
        out_ << ',';
    }
    if (depth_ > 0) {
        breakLine();
    }
    first_ = false;
}

void JsonWriter::breakLine() {
    if (layout_ == Layout::Indented) {
        out_ << '\n' << std::string(2 * depth_, ' ');
    }
}

std::string JsonWriter::text() {
    out_ << '\n';
    out_.flush();
    return std::move(sink_.text);
}

} // namespace forefront
