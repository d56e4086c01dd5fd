// The editor's program, which `forefront` starts.
#include "app/window/editor_entry.hpp"

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char **argv) {
    try {
        const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
        const auto arguments = forefront::editorArgumentsOf(words);
        if (!arguments) {
            std::fputs("forefront-editor: invalid arguments; start the editor with: forefront [FILE]\n", stderr);
            return 2;
        }
        return forefront::runEditor(*arguments);
    } catch (const std::bad_alloc &) {
        std::fputs("error: out of memory\n", stderr);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "error: %s\n", error.what());
    }
    return 1;
}
