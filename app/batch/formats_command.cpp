#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/outputs.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/version.hpp"
#include "core/files/json/json_writer.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kFormatsExamples = R"help(
The ids are what --format and --input-format accept. A file that is read is recognised by its content, else by its
extension.

Exit codes: 0 done, 1 cannot write, 2 usage error.)help";

/// Returns the parts that a format reads and writes, as words.
std::vector<std::string> readParts(const FileFormat &format) {
    std::vector<std::string> parts;
    if (format.readsDomain) {
        parts.emplace_back("domain");
    }
    if (format.readsMesh) {
        parts.emplace_back("mesh");
    }
    if (format.readsFields) {
        parts.emplace_back("values");
    }
    if (format.readsSpacing) {
        parts.emplace_back("spacing");
    }
    return parts;
}

std::string extensionsOf(const FileFormat &format) {
    const std::string others = format.otherExtensions;
    return format.extension + (others.empty() ? "" : ' ' + others);
}

std::string joined(const std::vector<std::string> &words) {
    std::string text;
    for (const std::string &word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

std::string column(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

std::string formatsTable() {
    std::string table =
        column("id", 11) + column("extension", 17) + column("reads", 31) + column("writes", 8) + "name\n";
    for (const FileFormat &format : allFormats().list()) {
        table += column(format.id, 11) + column(extensionsOf(format), 17) + column(joined(readParts(format)), 31) +
                 column(format.writesMesh ? "mesh" : "", 8) + format.name + '\n';
        if (format.component[0] != '\0') {
            table += column("", 11) + "Needs the component forefront-" + format.component + ".\n";
        }
        if (format.keeps[0] != '\0') {
            table += column("", 11) + format.keeps + '\n';
        }
    }
    return table;
}

std::string formatsJson() {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("version", version());
    json.key("formats").beginArray();
    for (const FileFormat &format : allFormats().list()) {
        json.beginObject().member("id", format.id).member("name", format.name);
        json.member("extensions", extensionsOf(format));
        json.key("reads").values(readParts(format));
        json.member("writes_mesh", format.writesMesh).member("keeps", format.keeps);
        std::vector<std::string> kinds;
        for (const CellKind kind : kElementKinds) {
            if (format.holds.has(kind)) {
                kinds.emplace_back(wordOf(kind));
            }
        }
        json.key("elements").values(kinds);
        json.member("elevations", format.holdsElevations).member("solids", format.holdsSolids);
        json.member("component", format.component);
        json.endObject();
    }
    return json.endArray().endObject().text();
}

} // namespace

int formatsCommand(const CommandLine &line) {
    bool json = false;
    CLI::App app("Lists the file formats that can be read and written.", "forefront formats");
    app.footer(kFormatsExamples);
    app.add_flag("--json", json, "print the list as JSON, with the kinds of elements that each format holds");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    const Status printed = printText(json ? formatsJson() : formatsTable());
    printFaults(printed);
    return printed.empty() ? kDone : kRefused;
}

} // namespace forefront
