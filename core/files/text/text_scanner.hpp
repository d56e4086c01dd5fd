#pragma once

#include "core/files/source/source.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// Parses the entire `text` as a finite or infinite number or NaN; accepts a leading '+' and Fortran's D exponent.
std::optional<double> parseReal(std::string_view text);

/// The purpose of a number in a file, for messages that are composed only when needed.
struct Expect {
    const char *what;           ///< "the coordinates of node"
    std::uint64_t number = kNo; ///< appended: "... of node 17"
    static constexpr std::uint64_t kNo = std::numeric_limits<std::uint64_t>::max();

    std::string words() const { return number == kNo ? what : what + (' ' + std::to_string(number)); }
};

/// Reads words and numbers from a text or one line of it. The first failure is kept with line and column; after it, all
/// reading fails. Counts in the text are checked against the bytes left.
class TextScanner {
  public:
    /// `comment`: the rest of a line from this character on is skipped; `separator`: treated as a blank.
    explicit TextScanner(const SourceText &source, char comment = '\0', char separator = ' ')
        : TextScanner(source, 0, source.text.size(), comment, separator) {}

    bool ok() const { return faults_.empty(); }
    const Diagnostics &faults() const { return faults_; }
    /// Makes failures also name the byte, since line numbers mean little in binary data.
    void nameBytes() { namesBytes_ = true; }
    /// Records a failure at a byte of the source; returns false for the caller to pass on.
    bool fail(std::size_t offset, std::string code, std::string message, std::string advice = {});
    /// Takes over the failure of another scanner, such as one of a line.
    bool fail(const TextScanner &other);

    /// Reports progress up to a byte of the source every few thousand lines; returns false, and fails, once reading has
    /// been cancelled. Numbers and lines call it; readers of binary data do so for each item.
    bool proceed(std::size_t offset) { return offset < pauseAt_ || pause(offset); }
    /// Returns true, and fails, if reading has been cancelled.
    bool stopped();

    std::size_t offset() const { return at_; }
    void seek(std::size_t offset) {
        at_ = std::min(offset, end_);
        pauseAt_ = std::min(pauseAt_, at_ + kPause); // reading the same text again can be cancelled, too
    }
    std::size_t remaining() const { return end_ - at_; }
    /// Returns true if only blanks and comments are left.
    bool atEnd() {
        skipBlanks();
        return at_ == end_;
    }

    /// Returns the next word without moving; empty at the end.
    std::string_view peek();
    std::string_view word();
    /// Reads a word in double quotes, or a bare word.
    bool quotedWord(std::string_view &text, Expect expect);
    /// Skips the expected word; fails on any other.
    bool literal(std::string_view expected);

    /// Reads a finite number.
    bool real(double &value, Expect expect);
    bool integer(std::int64_t &value, std::int64_t minimum, std::int64_t maximum, Expect expect);
    /// Reads a number of items that follow, each at least `bytes` long.
    bool count(std::size_t &value, std::size_t bytes, Expect expect);

    /// Sets `line` to a scanner of the next line that is not blank or a comment, at its first word. Returns false at
    /// the end.
    bool nextLine(TextScanner &line);
    /// Returns the rest of this text without surrounding blanks.
    std::string_view rest();
    /// Skips to the byte after the next line end.
    void skipLine();
    /// Returns a scanner of a part of the same source.
    TextScanner part(std::size_t begin, std::size_t end) const { return {*source_, begin, end, comment_, separator_}; }
    const SourceText &source() const { return *source_; }

  private:
    TextScanner(const SourceText &source, std::size_t begin, std::size_t end, char comment, char separator)
        : source_(&source), text_(source.text.data()), at_(begin), end_(end), pauseAt_(begin + kPause),
          comment_(comment), separator_(separator) {}

    static constexpr std::size_t kPause = std::size_t{1} << 16; ///< bytes between two checks of the stop token

    bool blank(char c) const { return static_cast<unsigned char>(c) <= ' ' || c == separator_; }
    bool delimits(std::size_t at) const { return at == end_ || blank(text_[at]) || text_[at] == comment_; }
    void skipBlanks();
    bool failExpected(const char *kind, Expect expect);
    bool pause(std::size_t offset);

    const SourceText *source_;
    const char *text_;
    std::size_t at_;
    std::size_t end_;
    std::size_t pauseAt_; ///< byte at which to check the stop token next
    char comment_;
    char separator_;
    bool namesBytes_ = false;
    Diagnostics faults_;
};

} // namespace forefront
