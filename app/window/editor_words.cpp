#include "app/window/editor_entry.hpp"

#include <charconv>
#include <string_view>

namespace forefront {

namespace {

constexpr std::string_view kFile = "--file=", kOther = "--other=", kFrames = "--frames=", kStateFile = "--state-file=",
                           kJudge = "--judge";

} // namespace

std::vector<std::string> editorWords(const EditorArguments &arguments) {
    std::vector<std::string> words;
    if (arguments.file) {
        words.push_back(std::string(kFile) + arguments.file->string());
    }
    for (const std::filesystem::path &other : arguments.others) {
        words.push_back(std::string(kOther) + other.string());
    }
    if (arguments.judge) {
        words.emplace_back(kJudge);
    }
    if (arguments.frames) {
        words.push_back(std::string(kFrames) + std::to_string(*arguments.frames));
    }
    if (arguments.stateFile) {
        words.push_back(std::string(kStateFile) + arguments.stateFile->string());
    }
    return words;
}

std::optional<EditorArguments> editorArgumentsOf(std::span<const std::string> words) {
    EditorArguments arguments;
    for (const std::string_view word : words) {
        if (word.starts_with(kFile)) {
            arguments.file = word.substr(kFile.size());
        } else if (word.starts_with(kOther)) {
            arguments.others.emplace_back(word.substr(kOther.size()));
        } else if (word.starts_with(kStateFile)) {
            arguments.stateFile = word.substr(kStateFile.size());
        } else if (word.starts_with(kFrames)) {
            int frames = 0;
            const auto [end, fault] = std::from_chars(word.data() + kFrames.size(), word.data() + word.size(), frames);
            if (fault != std::errc() || end != word.data() + word.size()) {
                return std::nullopt;
            }
            arguments.frames = frames;
        } else if (word == kJudge) {
            arguments.judge = true;
        } else {
            return std::nullopt;
        }
    }
    return arguments;
}

} // namespace forefront
