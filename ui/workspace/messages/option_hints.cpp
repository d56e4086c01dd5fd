#include "ui/workspace/messages/option_hints.hpp"

#include <cstddef>
#include <utility>

namespace forefront {
namespace {

/// An option of the command line, and what takes its place in a sentence.
struct OptionHint {
    std::string_view option, words;
};
constexpr OptionHint kHints[] = {{"--allow-degrees", "\"Keep degrees\""},
                                 {"--projection local", "\"Project to metres\""},
                                 {"--drop-lines", "\"Leave out lines\""},
                                 {"--layer", "\"Layer\""},
                                 {"--name-property", "\"Names from\""},
                                 {"--shape-regions", "\"Make every filled shape a region\""},
                                 {"--stroke-areas", "\"Mesh what the strokes paint\""},
                                 {"--no-white-holes", "without \"White shapes are holes\""},
                                 {"--white-holes", "\"White shapes are holes\""},
                                 {"--weld", "a weld tolerance of"}};

} // namespace

std::string withEditorHints(std::string text, std::string_view place) {
    for (const OptionHint &hint : kHints) {
        const std::string words = std::string(place).append(hint.words);
        for (std::size_t at = text.find(hint.option); at != std::string::npos;
             at = text.find(hint.option, at + words.size())) {
            text.replace(at, hint.option.size(), words);
        }
    }
    return text;
}

Diagnostic withEditorHints(Diagnostic diagnostic) {
    diagnostic.message = withEditorHints(std::move(diagnostic.message));
    diagnostic.advice = withEditorHints(std::move(diagnostic.advice));
    return diagnostic;
}

} // namespace forefront
