#include "tests/fuzz/fuzz_targets.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace forefront::fuzz;

namespace {

constexpr std::size_t kInputs = 4000; ///< for each target, shared by its seeds

/// Applies a few random edits: flips bytes, overwrites them by characters that matter in the formats, cuts out or
/// doubles parts.
std::string mutated(std::string text, std::mt19937 &random) {
    constexpr std::string_view kMeaningful = "09-+.eE\"'<>[]{}(),:/#%$*\n \xff";
    for (unsigned edits = 1 + random() % 4; edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random() % text.size();
        const std::size_t length = 1 + random() % 20;
        switch (random() % 5) {
        case 0:
            text[at] = static_cast<char>(text[at] ^ (1 << (random() % 8)));
            break;
        case 1:
            text[at] = kMeaningful[random() % kMeaningful.size()];
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(random() % text.size(), text.substr(at, length));
            break;
        default:
            text.insert(at, std::to_string(random()));
        }
    }
    return text;
}

} // namespace

/// Runs every target over its seeds and fixed mutations of them. A broken promise aborts. To repeat a
/// finding: forefront_fuzz_regression TARGET FILE.
int main(int argc, char **argv) {
    if (argc == 3) {
        const Target *target = find(argv[1]);
        std::FILE *file = target != nullptr ? std::fopen(argv[2], "rb") : nullptr;
        if (file == nullptr) {
            std::fprintf(stderr, "no target %s or no file %s\n", argv[1], argv[2]);
            return 2;
        }
        std::string bytes;
        for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
            bytes += static_cast<char>(c);
        }
        std::fclose(file);
        target->run(bytes);
        return 0;
    }
    for (const Target &target : targets()) {
        std::mt19937 random(1);
        std::size_t inputs = 0;
        const std::vector<std::string> list = seeds(target);
        for (const std::string &seed : list) {
            target.run(seed);
            for (std::size_t round = 0; round < kInputs / list.size(); ++round, ++inputs) {
                target.run(mutated(seed, random));
            }
        }
        std::printf("%-10s %zu inputs\n", target.name, inputs);
    }
    return 0;
}
