#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

/// A card of bulk data with its continuation lines.
struct NastranCard {
    std::string name;       ///< in capitals, without '*'
    std::size_t offset = 0; ///< of its first byte
    std::string fault;      ///< what is wrong with its lines; empty: nothing
    std::string advice;

    /// Returns the bytes of field k after the name, without surrounding blanks; an empty range where it has none.
    std::pair<std::size_t, std::size_t> field(std::size_t k) const {
        return k < fields_.size() ? fields_[k] : std::pair(offset, offset);
    }
    bool isEmpty(std::size_t k) const { return field(k).first == field(k).second; }

  private:
    friend class NastranCards;
    std::vector<std::pair<std::size_t, std::size_t>> fields_;
};

/// Splits bulk data into cards. Lines have a name and eight fields of 8 characters, or four of 16 if '*' follows the
/// name, or fields separated by commas. Continuation lines begin with a blank field, '+' or '*', and follow their card.
/// '$' begins a comment. Anything before BEGIN BULK, if the file has it, and after ENDDATA is skipped.
class NastranCards {
  public:
    explicit NastranCards(std::string_view text);

    /// Reads the next card; returns false at the end.
    bool next(NastranCard &card);

  private:
    struct Line {
        std::size_t begin = 0, end = 0;
    };

    bool nextLine(Line &line);
    bool continues(const Line &line) const;
    void addFields(const Line &line, NastranCard &card) const;
    std::size_t nameEnd(const Line &line) const;

    std::string_view text_;
    std::size_t at_ = 0;
    Line pending_;
    bool hasPending_ = false;
};

} // namespace forefront
