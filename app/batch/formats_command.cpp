#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/outputs.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/version.hpp"
#include "core/files/json/json_writer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
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
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

/// Returns one row per format: id, extensions, what is read, what is written, name.
std::vector<std::array<std::string, 5>> formatRows(const std::vector<FileFormat> &formats) {
    std::vector<std::array<std::string, 5>> rows{{"id", "extension", "reads", "writes", "name"}};
    for (const FileFormat &format : formats) {
        rows.push_back(
            {format.id, extensionsOf(format), joined(readParts(format)), format.writesMesh ? "mesh" : "", format.name});
    }
    return rows;
}

std::string formatsTable() {
    const std::vector<FileFormat> formats = allFormats().list();
    const std::vector<std::array<std::string, 5>> rows = formatRows(formats);
    std::array<std::size_t, 5> widths{};
    for (const auto &row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k) { // names end the lines
            widths[k] = std::max(widths[k], row[k].size() + 2);
        }
    }
    std::string table;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t k = 0; k < rows[r].size(); ++k) {
            table += column(rows[r][k], widths[k]);
        }
        table += '\n';
        if (r == 0) {
            continue;
        }
        const FileFormat &format = formats[r - 1];
        if (format.component[0] != '\0') {
            table += column("", widths[0]) + "Needs the component forefront-" + format.component + ".\n";
        }
        if (format.keeps[0] != '\0') {
            table += column("", widths[0]) + format.keeps + '\n';
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
