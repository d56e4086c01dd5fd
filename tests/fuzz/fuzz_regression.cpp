#include "tests/fuzz/fuzz_targets.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront::fuzz;

namespace {

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

/// Runs a file again. Returns the exit code.
int repeat(const Target &target, const char *path) {
    std::FILE *const file = std::fopen(path, "rb");
    if (file == nullptr) {
        std::fprintf(stderr, "no file %s\n", path);
        return 2;
    }
    std::string bytes;
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
        bytes += static_cast<char>(c);
    }
    std::fclose(file);
    target.run(bytes);
    return 0;
}

/// Keeps an input, so that one that ends the program is found in a file. Returns false if it cannot.
bool keep(const std::string &path, const std::string &bytes) {
    std::FILE *const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) {
        return false;
    }
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return std::fclose(file) == 0 && written;
}

/// Runs mutations of the seeds for a number of seconds. Returns the exit code.
int runLong(const Target &target, long seconds, unsigned seed) {
    using Clock = std::chrono::steady_clock;
    const std::string path = std::string("fuzz_") + target.name + '_' + std::to_string(seed) + ".input";
    const Clock::time_point end = Clock::now() + std::chrono::seconds(seconds);
    std::mt19937 random(seed);
    const std::vector<std::string> list = seeds(target);
    std::size_t inputs = 0;
    for (; Clock::now() < end; ++inputs) {
        const std::string input = mutated(list[random() % list.size()], random);
        if (!keep(path, input)) {
            std::fprintf(stderr, "cannot write %s\n", path.c_str());
            return 2;
        }
        target.run(input);
    }
    std::remove(path.c_str());
    std::printf("%-10s %zu inputs\n", target.name, inputs);
    return 0;
}

/// Runs every target over its seeds and fixed mutations of them.
void runAll() {
    for (const Target &target : targets()) {
        std::mt19937 random(1);
        std::size_t inputs = 0;
        const std::vector<std::string> list = seeds(target);
        for (const std::string &seed : list) {
            target.run(seed);
            for (std::size_t round = 0; round < target.inputs / list.size(); ++round, ++inputs) {
                target.run(mutated(seed, random));
            }
        }
        std::printf("%-10s %zu inputs\n", target.name, inputs);
    }
}

} // namespace

/// Runs every target; a broken promise aborts. `forefront_fuzz_regression TARGET FILE` repeats a finding;
/// `forefront_fuzz_regression TARGET SECONDS SEED` runs longer, and leaves an input that ends the program in
/// fuzz_TARGET_SEED.input.
int main(int argc, char **argv) {
    if (argc < 2) {
        runAll();
        return 0;
    }
    const Target *const target = find(argv[1]);
    if (target == nullptr || argc < 3 || argc > 4) {
        std::fprintf(stderr, "usage: forefront_fuzz_regression [TARGET FILE | TARGET SECONDS SEED]\n");
        return 2;
    }
    return argc == 3 ? repeat(*target, argv[2])
                     : runLong(*target, std::atol(argv[2]), static_cast<unsigned>(std::atol(argv[3])));
}
