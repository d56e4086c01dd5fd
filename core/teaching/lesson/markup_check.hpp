#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/files/json/json.hpp"
#include "core/files/source/source.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/lesson/lesson_picture.hpp"
#include "core/teaching/lesson/random_numbers.hpp"
#include "core/teaching/markup/marked_text.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

/// Returns true if a path stays in the folder that it is relative to.
bool isWithinFolder(const std::filesystem::path &path);

/// Checks the formulas, images and links in the texts of a lesson, page by page. Faults name the page, and their place
/// is that of the markup within its text.
class MarkupCheck {
  public:
    /// Reads the picture of a file, by its path relative to the lesson.
    using ReadPicture = std::function<LessonPicture(const std::string &file)>;

    /// `source` must outlive the check. `readPicture`: empty, pictures are not read.
    MarkupCheck(const SourceText &source, ReadPicture readPicture)
        : source_(source), readPicture_(std::move(readPicture)) {}

    /// Checks the texts of the next page, an object. `numbers`: its random numbers, which image files may name.
    void page(const JsonValue &page, const RandomNumbers &numbers);
    /// Checks that the pages exist that links lead to, once all are known.
    void links(const Lesson &lesson);
    const Diagnostics &faults() const { return faults_; }
    /// Returns the pictures of all pages, by their files.
    LessonPictures takePictures() { return std::move(pictures_); }

  private:
    /// A link to another page, and its place.
    struct Link {
        JsonValue text;
        std::size_t at = 0;
        std::string target;
        std::size_t page = 0;
    };

    void question(const JsonValue &question);
    void list(const JsonValue &item, std::string_view member, MarkupKind textKind);
    void member(const JsonValue &object, std::string_view name, MarkupKind kind = MarkupKind::All);
    void text(const JsonValue &value, MarkupKind kind);
    void image(const JsonValue &value, const TextPiece &piece);
    void fault(const JsonValue &value, std::size_t at, const std::string &code, const std::string &message,
               const std::string &advice, std::size_t page);

    const SourceText &source_;
    ReadPicture readPicture_;
    const RandomNumbers *numbers_ = nullptr;
    std::size_t page_ = 0; ///< that is being checked; counted from 1
    std::vector<Link> links_;
    LessonPictures pictures_;
    Diagnostics faults_;
    std::size_t bytes_ = 0; ///< of all pictures
};

} // namespace forefront
