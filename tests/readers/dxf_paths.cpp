// Prints what the DXF reader finds in a file, for an independent comparison: for each layer the number of paths, their
// total length and their bounds, as JSON. Exit code 1 with the faults if the file is refused.
//
//     forefront_dxf_paths FILE

#include "core/drawing_files/dxf/dxf_drawing.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/files/source/source.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <map>
#include <string>

int main(int argc, char **argv) {
    using namespace forefront;
    const auto print = [](const std::string &text) { std::printf("%s\n", text.c_str()); };
    const Result<std::string> bytes = argc == 2 ? readFileBytes(argv[1], std::size_t{1} << 30)
                                                : Result<std::string>(error("usage", "expected one file"));
    if (!bytes) {
        print(toString(bytes.faults().front()));
        return 1;
    }
    ImportNotes notes;
    SourceText source{*bytes, argv[1], argv[1], {}};
    source.notes = &notes;
    const Result<DxfFile> file = readDxfFile(source);
    const Result<DxfPaths> drawn = file ? drawDxf(*file, source) : file.faults();
    if (!drawn) {
        print(toString(drawn.faults().front()));
        return 1;
    }
    struct Sum {
        std::size_t paths = 0;
        double length = 0.0;
        Box2 box;
    };
    std::map<std::string, Sum> sums;
    for (const DxfPath &path : drawn->paths) {
        Sum &sum = sums[drawn->layers[path.layer]];
        ++sum.paths;
        for (std::size_t k = path.first; k < path.first + path.count; ++k) {
            sum.length += drawn->curves[k].length();
            sum.box.add(drawn->curves[k].bounds());
        }
    }
    nlohmann::json all{
        {"units", file->units}, {"layers", nlohmann::json::object()}, {"notes", nlohmann::json::array()}};
    for (const auto &[layer, sum] : sums) {
        all["layers"][layer] = {{"paths", sum.paths},
                                {"length", sum.length},
                                {"box", {sum.box.min.x, sum.box.min.y, sum.box.max.x, sum.box.max.y}}};
    }
    for (const ImportNote &note : notes.entries()) {
        all["notes"].push_back({{"code", note.code}, {"message", note.message}, {"count", note.count}});
    }
    print(all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    return 0;
}
