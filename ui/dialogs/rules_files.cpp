#include "core/files/rules/rules_json.hpp"
#include "core/files/text/atomic_file.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"

#include <memory>
#include <utility>

namespace forefront {

namespace {

FileFilter rulesFilter() {
    return {"Rules of the classic method (.json)", {".json"}, "rules"};
}

Diagnostics useRules(Shell &context, const std::filesystem::path &file) {
    const Result<FrontRules> rules = readRulesFile(file);
    if (!rules) {
        return rules.faults();
    }
    Document next = *context.document.current();
    const bool other = next.options.method != Method::Classic || next.options.elements != Elements::Triangles;
    next.options.rules = *rules;
    next.options.method = Method::Classic; // no other method has these rules
    next.options.elements = Elements::Triangles;
    context.document.apply(std::move(next), "Open rules");
    const std::string changes = changesText(*rules);
    context.log.announce("Opened rules from " + file.filename().string() + ": " +
                         (changes.empty() ? "all have their defaults" : changes) +
                         (other ? "; the method is now Classic" : ""));
    return {};
}

Status writeRulesFile(const std::filesystem::path &file, const FrontRules &rules) {
    if (Status fault = notRegular(file); !fault.empty()) {
        return fault;
    }
    JsonWriter json(JsonWriter::Layout::Indented);
    writeRules(rules, json);
    return writeFileAtomically(file, json.text());
}

} // namespace

void openRules(Shell &context) {
    FileRequest request;
    request.id = "openrules";
    request.title = "Open rules";
    request.action = "Open";
    request.filters = {rulesFilter(), {"All files", {}, "any"}};
    request.folder = startFolder(context);
    request.chosen = [](Shell &c, const std::filesystem::path &file, const FileFilter &) { return useRules(c, file); };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

void saveRules(Shell &context) {
    FileRequest request;
    request.id = "saverules";
    request.title = "Save rules";
    request.action = "Save";
    request.saves = true;
    request.filters = {rulesFilter()};
    request.folder = startFolder(context);
    request.name = "rules.json";
    request.chosen = [](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        Status status = writeRulesFile(file, c.document.current()->options.rules);
        if (status.empty()) {
            c.log.announce("Saved rules to " + file.string());
        }
        return status;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
