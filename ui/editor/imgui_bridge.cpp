#include "ui/editor/imgui_bridge.hpp"

#include "ui/platform/platform.hpp"
#include "ui/style/imgui_versions.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <string>

namespace forefront {

namespace {

const char *readClipboard(void *user) {
    // Dear ImGui needs a pointer that outlives the call.
    static thread_local std::string text;
    text = static_cast<Platform *>(user)->clipboard();
    return text.c_str();
}

void writeClipboard(void *user, const char *text) {
    static_cast<Platform *>(user)->setClipboard(text);
}

/// Returns true while a menu or a list is open, not only dialogs.
bool menuIsOpen() {
    const ImVector<ImGuiPopupData> &open = ImGui::GetCurrentContext()->OpenPopupStack;
    return !open.empty() && open.back().Window != nullptr && (open.back().Window->Flags & ImGuiWindowFlags_Modal) == 0;
}

/// Lets the arrow keys move through an open menu, and Enter run the chosen item.
void feedMenu(ImGuiIO &io) {
    const bool open = menuIsOpen();
    io.ConfigFlags = open ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
                          : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
    if (open) {
        imgui::feedEnterToMenu();
    }
}

} // namespace

ImGuiBridge::ImGuiBridge(Platform &platform) : platform_(platform), context_(ImGui::CreateContext()) {
    IMGUI_CHECKVERSION();
    activate();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr; // the layout is fixed, so there is nothing to save
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.GetClipboardTextFn = readClipboard;
    io.SetClipboardTextFn = writeClipboard;
    io.ClipboardUserData = &platform_;
    io.KeyRepeatDelay = 1e30F; // only the keyboard repeats keys: a slow frame must not count as a key held down
    imgui::mapKeys();
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

ImGuiBridge::~ImGuiBridge() {
    activate();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

void ImGuiBridge::activate() {
    ImGui::SetCurrentContext(context_);
}

void ImGuiBridge::fontsChanged() {
    imgui::uploadFonts();
}

void ImGuiBridge::feed(const InputEvent &event) {
    ImGuiIO &io = ImGui::GetIO();
    switch (event.kind) {
    case InputKind::MouseMove:
        io.MousePos = {static_cast<float>(event.x), static_cast<float>(event.y)};
        break;
    case InputKind::MouseButton:
        if (event.code >= 0 && event.code < 5) {
            io.MouseDown[event.code] = event.pressed;
            if (event.pressed) { // Dear ImGui only knows when frames take the clicks, which may be long after
                constexpr float kDoubleClick = 0.3F, kAnyTime = 1e9F; // seconds
                const double arrived = event.arrival(platform_.now());
                const bool again = arrived - pressedAt_ < static_cast<double>(kDoubleClick);
                io.MouseDoubleClickTime = again ? kAnyTime : kDoubleClick;
                pressedAt_ = arrived;
            }
        }
        break;
    case InputKind::Scroll:
        io.MouseWheelH += static_cast<float>(event.x);
        io.MouseWheel += static_cast<float>(event.y);
        break;
    case InputKind::Key:
        imgui::feedKey(event.code, event.pressed, event.repeated);
        break;
    case InputKind::Text:
        if (event.code > 0) {
            io.AddInputCharacter(static_cast<unsigned>(event.code));
        }
        break;
    case InputKind::Focus:
        io.AddFocusEvent(event.pressed);
        if (!event.pressed) {
            imgui::releaseKeys();
        }
        break;
    case InputKind::Drop:
    case InputKind::Close:
        break;
    }
}

void ImGuiBridge::beginFrame(std::span<const InputEvent> events, double elapsedSeconds) {
    ImGuiIO &io = ImGui::GetIO();
    for (const InputEvent &event : events) {
        feed(event);
    }
    feedMenu(io);
    const PixelSize size = platform_.framebufferSize();
    io.DisplaySize = {static_cast<float>(std::max(size.width, 1)), static_cast<float>(std::max(size.height, 1))};
    io.DisplayFramebufferScale = {1.0F, 1.0F};
    io.DeltaTime = static_cast<float>(std::clamp(elapsedSeconds, 1e-4, 0.25));
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void ImGuiBridge::endFrame() {
    ImGui::Render();
    if (platform_.shown()) {
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }
}

} // namespace forefront
