#include "core/files/files.hpp"
#include "tests/fuzz/fuzz_targets.hpp"

#include <cstdio>

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fputs("usage: forefront_fuzz_seeds FOLDER\n", stderr);
        return 2;
    }
    for (const auto &target : forefront::fuzz::targets()) {
        const std::filesystem::path folder = std::filesystem::path(argv[1]) / target.name;
        std::filesystem::create_directories(folder);
        int number = 0;
        for (const std::string &seed : forefront::fuzz::seeds(target)) {
            if (!forefront::writeFileAtomically(folder / ("seed" + std::to_string(number++)), seed).empty()) {
                std::fprintf(stderr, "cannot write to %s\n", folder.c_str());
                return 1;
            }
        }
    }
    return 0;
}
