#include "app/batch/several_inputs.hpp"

#include "app/batch/exit_code.hpp"
#include "app/batch/inputs.hpp"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace forefront {

namespace {

constexpr std::string_view kStemPlace = "{}";

bool hasStemPlace(const std::filesystem::path &pattern) {
    return pattern.string().find(kStemPlace) != std::string::npos;
}

} // namespace

std::filesystem::path withStem(const std::filesystem::path &pattern, const std::filesystem::path &input) {
    std::string text = pattern.string();
    const std::string stem = input.stem().string();
    for (std::size_t at = text.find(kStemPlace); at != std::string::npos; at = text.find(kStemPlace, at)) {
        text.replace(at, kStemPlace.size(), stem);
        at += stem.size();
    }
    return text;
}

std::string checkStems(const std::vector<std::filesystem::path> &inputs,
                       const std::vector<std::filesystem::path> &outputs) {
    const bool fromStream = std::any_of(inputs.begin(), inputs.end(), isStandardStream);
    if (fromStream && inputs.size() > 1) {
        return "standard input '-' is one of several inputs; expected it alone";
    }
    for (const std::filesystem::path &output : outputs) {
        if (fromStream && hasStemPlace(output)) {
            return "'" + output.string() + "': standard input has no name to replace {}; name the output";
        }
        if (inputs.size() > 1 && !hasStemPlace(output)) {
            return "'" + output.string() + "': one output for " + std::to_string(inputs.size()) +
                   " inputs, among them '" + inputs[1].string() +
                   "'; put {}, the name of each input without its extension, into the name";
        }
    }
    return {};
}

int runEach(const std::vector<std::filesystem::path> &inputs, bool quiet, const std::function<int(std::size_t)> &run) {
    int worst = kDone;
    std::string refused;
    std::size_t count = 0;
    for (std::size_t k = 0; k < inputs.size() && worst != kCancelled; ++k) {
        if (inputs.size() > 1 && !quiet) {
            std::printf("%s%s:\n", k == 0 ? "" : "\n", inputs[k].string().c_str());
            std::fflush(stdout); // before the faults on stderr
        }
        const int code = run(k);
        std::fflush(stdout);
        if (code != kDone && code != kCancelled) {
            refused += (count++ == 0 ? "" : ", ") + inputs[k].string();
        }
        worst = std::max(worst, code);
    }
    if (inputs.size() > 1 && count > 0) {
        std::fprintf(stderr, "%zu of %zu inputs refused: %s\n", count, inputs.size(), refused.c_str());
    }
    return worst;
}

} // namespace forefront
