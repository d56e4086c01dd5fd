#include "ui/dialogs/file_dialog.hpp"

#include "core/engine/base/letter_case.hpp"
#include "core/files/files.hpp"
#include "core/files/source/source.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/messages/option_hints.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace forefront {
namespace {

std::string dateText(std::int64_t modified) {
    const auto time = static_cast<std::time_t>(modified);
    std::tm parts{};
    if (modified == 0 || ::localtime_r(&time, &parts) == nullptr) {
        return {};
    }
    char buffer[32];
    return std::strftime(buffer, sizeof buffer, "%Y-%m-%d %H:%M", &parts) > 0 ? buffer : std::string();
}

/// Formats a fault in one line: the place in the file, the message, the advice.
std::string lineOf(const Diagnostic &fault) {
    std::string text;
    if (!fault.file.empty()) {
        text = std::filesystem::path(fault.file).filename().string();
        text += fault.line > 0 ? ", line " + std::to_string(fault.line) + ": " : ": ";
    }
    text += fault.message;
    return withEditorHints(fault.advice.empty() ? text : text + "; " + fault.advice);
}

} // namespace

FileDialog::FileDialog(FileRequest request) : request_(std::move(request)) {
    browses_ = request_.presets.empty();
    std::error_code failed;
    std::filesystem::path folder = request_.folder;
    if (folder.empty() || !std::filesystem::is_directory(folder, failed)) {
        folder = std::filesystem::current_path(failed);
    }
    enter(failed ? std::filesystem::path("/") : folder);
}

void FileDialog::enter(const std::filesystem::path &folder) {
    Result<std::vector<FileEntry>> listed = listFolder(folder, filter());
    if (!listed) {
        fault_ = listed.faults().front().message;
        return;
    }
    fault_.clear();
    entries_ = std::move(listed).value();
    folder_ = folder;
    replace_.reset();
}

void FileDialog::recallFolder(const Shell &context) {
    const auto known = context.settings.folders.find(request_.id);
    std::error_code ignored;
    if (!request_.fixedFolder && known != context.settings.folders.end() &&
        std::filesystem::is_directory(known->second, ignored)) {
        enter(known->second);
    }
}

void FileDialog::suggest(std::string name) {
    request_.name = std::move(name);
    replace_.reset();
    fault_.clear();
}

std::vector<std::string> FileDialog::recentFiles(const Shell &context) const {
    std::vector<std::string> files = request_.recent;
    for (const std::string &file : context.settings.recentFiles) {
        if (passes(request_.filters.front(), file) && std::find(files.begin(), files.end(), file) == files.end()) {
            files.push_back(file);
        }
    }
    return files;
}

void FileDialog::drawPlaces(Shell &context) {
    const auto place = [&](const char *name, const char *icon, const std::string &label,
                           const std::filesystem::path &at) {
        std::error_code ignored;
        if (at.empty() || !std::filesystem::is_directory(at, ignored)) {
            return;
        }
        ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0.0F, 0.5F));
        if (ui::button(context, widget(name), std::string(icon) + "  " + label, ui::ButtonKind::Quiet, true, 126.0F)) {
            enter(at);
        }
        ImGui::PopStyleVar();
    };
    const char *home = std::getenv("HOME");
    place("place/home", icon::kHome, "Home", home != nullptr ? home : "");
    std::error_code ignored;
    place("place/work", icon::kFolder, "Working folder", std::filesystem::current_path(ignored));
    const std::filesystem::path &document = context.document.path();
    if (!document.empty()) {
        place("place/document", icon::kFile, "Drawing folder", document.parent_path());
    }
    place("place/root", icon::kComputer, "Computer", "/");
    const std::vector<std::string> recent = recentFiles(context);
    if (recent.empty() || request_.saves) {
        return;
    }
    ImGui::Dummy({0, context.px(6)});
    ui::heading(context, "Recent");
    for (std::size_t k = 0; k < std::min<std::size_t>(5, recent.size()); ++k) {
        const std::filesystem::path file = recent[k];
        ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0.0F, 0.5F));
        if (ui::button(context, widget("recent/") + std::to_string(k), file.filename().string(), ui::ButtonKind::Quiet,
                       true, 126.0F)) {
            enter(file.parent_path());
            suggest(file.filename().string());
        }
        ImGui::PopStyleVar();
        ui::tooltip(context, file.string());
    }
}

void FileDialog::drawPath(Shell &context) {
    if (ui::iconButton(context, widget("up"), icon::kUp, "Parent folder", false, folder_.has_relative_path(), 28.0F)) {
        enter(folder_.parent_path());
    }
    ImGui::SameLine();
    std::string path = folder_.string();
    const float room = ImGui::GetContentRegionAvail().x / context.scale;
    if (ui::entry(context, widget("path"), path, "folder", room - (request_.saves ? 36.0F : 0.0F))) {
        const std::filesystem::path typed = resolved(folder_, path);
        std::error_code ignored;
        if (std::filesystem::is_directory(typed, ignored)) {
            enter(typed);
        } else {
            suggest(typed.filename().string());
            enter(typed.parent_path());
        }
    }
    if (!request_.saves) {
        return;
    }
    ImGui::SameLine();
    if (ui::iconButton(context, widget("newfolder"), icon::kPlus, "New folder", newFolder_, true, 28.0F)) {
        newFolder_ = !newFolder_;
        newFolderName_ = "New folder";
    }
    if (newFolder_ && ui::inputText(context, widget("newfolder/name"), newFolderName_, "name", 436.0F, true, false) &&
        !newFolderName_.empty()) {
        std::error_code failed;
        const std::filesystem::path made = resolved(folder_, newFolderName_);
        std::filesystem::create_directory(made, failed);
        newFolder_ = false;
        if (failed) {
            fault_ = made.string() + ": " + failed.message();
        } else {
            enter(made);
        }
    }
}

bool FileDialog::drawRow(Shell &context, const FileEntry &entry) {
    const std::string name = widget("list/") + entry.name;
    const std::string label = std::string(entry.folder ? icon::kFolder : icon::kFile) + "   " + entry.name;
    const std::string detail =
        entry.folder ? dateText(entry.modified) : fileSizeText(entry.size) + "    " + dateText(entry.modified);
    const bool pressed = ui::selectable(context, name, label, entry.name == request_.name, detail);
    const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (pressed && !entry.folder) {
        suggest(entry.name);
    }
    return twice || (pressed && entry.folder);
}

void FileDialog::typeAhead(Shell &context) {
    constexpr double kPause = 1.0; // seconds, after which a new name begins
    const double now = context.platform.now();
    if (request_.saves || entries_.empty() || ui::typing().active || reading_) {
        return;
    }
    const auto chosen = std::find_if(entries_.begin(), entries_.end(),
                                     [&](const FileEntry &entry) { return entry.name == request_.name; });
    auto next = entries_.end();
    if (imgui::keyPressed(key::kDown)) {
        next = chosen == entries_.end() ? entries_.begin() : std::min(chosen + 1, entries_.end() - 1);
    } else if (imgui::keyPressed(key::kUp)) {
        next = chosen == entries_.end() || chosen == entries_.begin() ? entries_.begin() : chosen - 1;
    }
    const ImVector<ImWchar> &typed = ImGui::GetIO().InputQueueCharacters;
    for (const ImWchar letter : typed) {
        typed_ = now - typedAt_ > kPause ? std::string() : typed_;
        typedAt_ = now;
        if (letter >= ' ' && letter < 0x80) {
            typed_ += static_cast<char>(letter);
        }
    }
    if (!typed.empty() && !typed_.empty()) {
        next = std::find_if(entries_.begin(), entries_.end(), [&](const FileEntry &entry) {
            return lowerCase(entry.name).starts_with(lowerCase(typed_));
        });
    }
    if (next != entries_.end()) {
        suggest(next->name);
        const float row = context.px(26) + ImGui::GetStyle().ItemSpacing.y;
        const float at = row * static_cast<float>(next - entries_.begin());
        ImGui::SetScrollY(std::max(0.0F, at - 0.5F * ImGui::GetWindowHeight()));
        context.animate();
    }
}

bool FileDialog::drawList(Shell &context) {
    bool opened = false;
    typeAhead(context);
    if (entries_.empty()) {
        ImGui::SetCursorPos({context.px(10), context.px(8)});
        ui::muted(context, "No files of this kind here");
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(entries_.size()));
    std::optional<std::string> below;
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            const FileEntry &entry = entries_[static_cast<std::size_t>(k)];
            if (drawRow(context, entry)) {
                if (entry.folder) {
                    below = entry.name;
                } else {
                    opened = true;
                }
            }
        }
    }
    if (below) {
        enter(folder_ / *below);
    }
    return opened;
}

void FileDialog::followExtension(const std::string &name) {
    const std::size_t before = request_.filter;
    for (std::size_t i = 0; i < request_.filters.size() && !passes(filter(), name); ++i) {
        if (!request_.filters[i].extensions.empty() && passes(request_.filters[i], name)) {
            request_.filter = i;
        }
    }
    if (request_.filter != before) {
        enter(folder_); // to list the files of the format
    }
}

std::string FileDialog::replacedBy(const std::filesystem::path &file) const {
    const std::vector<std::filesystem::path> written =
        request_.writes ? request_.writes(file, filter()) : std::vector<std::filesystem::path>{file};
    std::vector<std::string> names;
    for (const std::filesystem::path &each : written) {
        std::error_code ignored;
        if (std::filesystem::exists(each, ignored)) {
            names.push_back(each.filename().string());
        }
    }
    std::string list;
    for (std::size_t k = 0; k < names.size(); ++k) {
        list += (k == 0 ? "" : k + 1 < names.size() ? ", " : " and ") + names[k];
    }
    return names.empty() ? list : list + (names.size() == 1 ? " already exists" : " already exist");
}

bool FileDialog::choose(Shell &context) {
    if (request_.name.empty()) {
        return false;
    }
    std::filesystem::path file = resolved(folder_, request_.name);
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        enter(file);
        request_.name.clear();
        return false;
    }
    Diagnostics faults;
    if (request_.saves) {
        followExtension(file.filename().string());
        faults = checkExtension(file.filename().string(), request_.filters);
        if (faults.empty()) {
            file.replace_filename(withExtension(file.filename().string(), filter(), request_.filters));
            faults = checkPlace(file);
        }
        if (faults.empty()) {
            faults = notRegular(file); // writing to a pipe could wait for ever
        }
        if (faults.empty() && replace_ != file) {
            replaced_ = replacedBy(file);
            if (!replaced_.empty()) {
                replace_ = file;
                return false;
            }
        }
    } else if (!std::filesystem::exists(file, ignored)) {
        fault_ = file.filename().string() + " not found";
        focusName_ = true;
        return false;
    }
    replace_.reset();
    chosen_ = file;
    if (faults.empty() && request_.reads) {
        fault_.clear();
        reading_ = request_.reads(context, file);
        if (reading_) {
            return false;
        }
    }
    if (faults.empty()) {
        faults = request_.chosen(context, file, filter());
    }
    return show(context, faults);
}

bool FileDialog::show(Shell &context, const Diagnostics &faults) {
    context.log.keep(faults);
    fault_ = faults.empty() ? std::string() : lineOf(faults.front());
    focusName_ = focusName_ || !faults.empty(); // to type another
    if (faults.empty()) {
        context.settings.folders[request_.id] = chosen_.parent_path().string();
    }
    return faults.empty();
}

bool FileDialog::followReading(Shell &context) {
    if (!reading_) {
        return true;
    }
    if (imgui::keyPressed(key::kEscape, false)) {
        cancelReading(context);
        return true;
    }
    if (context.task.ready()) {
        context.task.finish();
    }
    if (!reading_->done) {
        reading_ = context.task.busy() ? reading_ : nullptr; // another task may have replaced it
        return true;
    }
    const Diagnostics faults = std::exchange(reading_, nullptr)->faults;
    return !show(context, faults);
}

void FileDialog::cancelReading(Shell &context) {
    cancelTask(context);
    reading_.reset();
}

/// Draws how far reading is, in place of the warning.
void FileDialog::drawReading(Shell &context) {
    const BackgroundTask &task = context.task;
    ui::muted(context, task.name() + ui::format("\xe2\x80\xa6 %.0f %%", 100.0 * task.fraction()));
    ui::mark(context, widget("reading"));
}

std::string FileDialog::warning() const {
    if (!fault_.empty() || !replace_) {
        return fault_;
    }
    return replaced_;
}

void FileDialog::useFilter(std::size_t filter) {
    request_.filter = filter;
    if (request_.saves) {
        request_.name = withExtension(request_.name, this->filter(), request_.filters);
    }
    enter(folder_);
}

void FileDialog::drawName(Shell &context, bool &wanted) {
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "Name");
    ImGui::SameLine(context.px(72));
    std::string name = request_.name;
    if (ui::inputText(context, widget("name"), name, request_.saves ? "file name" : "name or path", 340.0F, true,
                      focusName_)) {
        wanted = true;
    }
    focusName_ = false;
    if (name != request_.name) {
        suggest(name);
        if (request_.saves) {
            followExtension(name);
        }
    }
    ImGui::SameLine();
    std::vector<const char *> labels;
    for (const FileFilter &kind : request_.filters) {
        labels.push_back(kind.name.c_str());
    }
    int kind = static_cast<int>(request_.filter);
    if (ui::combo(context, widget("filter"), labels, kind)) {
        useFilter(static_cast<std::size_t>(kind));
    }
}

bool FileDialog::drawBottom(Shell &context) {
    bool wanted = false;
    if (!request_.presets.empty()) {
        drawPresets(context);
    }
    drawName(context, wanted);
    if (!browses_) {
        drawFolder(context);
    }
    if (hasNotes()) {
        drawNote(context);
    }
    const bool allowed = !request_.extra || request_.extra(context, filter());
    ImGui::Dummy({0, context.px(4)});
    const std::string label = replace_ ? "Replace" : request_.actionNow ? request_.actionNow(context) : request_.action;
    const float padding = 2.0F * ImGui::GetStyle().FramePadding.x + context.px(8);
    const float okWidth = std::max(context.px(kButton), ImGui::CalcTextSize(label.c_str()).x + padding);
    const float buttons = ImGui::GetWindowContentRegionMax().x - context.px(kButton + kButtonGap) - okWidth;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, fault_.empty() ? context.theme.warn : context.theme.bad);
    const float top = ImGui::GetCursorPosY();
    ui::wrappedText(warning(), buttons - context.px(kButtonGap) - ImGui::GetCursorPosX());
    ImGui::PopStyleColor();
    ui::mark(context, widget("warning"));
    if (reading_) {
        ImGui::SetCursorPosY(top);
        drawReading(context);
    }
    ImGui::SetCursorPos({buttons, top});
    const bool cancelled = ui::button(context, widget("cancel"), "Cancel", ui::ButtonKind::Plain, true, kButton);
    ImGui::SameLine(0, context.px(kButtonGap));
    const bool ready = allowed && !request_.name.empty() && !reading_;
    wanted = ui::button(context, widget("ok"), label, ui::ButtonKind::Primary, ready, okWidth / context.scale) ||
             wanted || entered_;
    if (cancelled && reading_) {
        cancelReading(context);
        return true;
    }
    wanted = wanted && !ui::showsFault(context, widget(""));
    return !cancelled && !(wanted && ready && choose(context));
}

bool FileDialog::draw(Shell &context) {
    if (!std::exchange(recalled_, true)) {
        recallFolder(context);
    }
    entered_ = ui::enterOutsideFields(); // such as after a click on a file
    if (!followReading(context)) {
        return false;
    }
    const bool opened = browses_ && drawBrowser(context);
    const bool stays = drawBottom(context);
    if (opened && stays && !reading_ && (!request_.extra || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))) {
        return !choose(context);
    }
    return stays;
}

bool FileDialog::drawBrowser(Shell &context) {
    const float height = ImGui::GetContentRegionAvail().y - bottomHeight(context);
    ImGui::BeginChild("places", {context.px(134), height}, false, ImGuiWindowFlags_NoNav);
    drawPlaces(context);
    ImGui::EndChild();
    ImGui::SameLine(0, context.px(14));
    ImGui::BeginGroup();
    drawPath(context);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, context.theme.panel);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(6), context.px(6)));
    ImGui::BeginChild("files", {0, height - ImGui::GetFrameHeightWithSpacing() * (newFolder_ ? 2.0F : 1.0F)}, true,
                      ImGuiWindowFlags_NoNav);
    const bool opened = drawList(context);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::EndGroup();
    return opened;
}

} // namespace forefront
