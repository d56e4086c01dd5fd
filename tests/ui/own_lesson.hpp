#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace forefront::test {

/// Writes the file of a lesson "Mine" of one page with a text, and a question whose first choice is right. `more`:
/// further members of the page, and further pages.
inline void writeOwnLesson(const std::filesystem::path &file, const std::string &text, const std::string &more = "}") {
    std::ofstream(file) << R"({"format": "forefront-lesson", "version": 1, "title": "Mine", "pages": [
            {"title": "A", "text": ")"
                        << text
                        << R"(", "question": {"text": "q", "choices": [{"text": "a", "right": true}, {"text": "b"}]})"
                        << more << "]}";
}

} // namespace forefront::test
