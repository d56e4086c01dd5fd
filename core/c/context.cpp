#include "core/c/handles.hpp"
#include "core/engine/base/version.hpp"
#include "core/files/json/json_writer.hpp"

#include <limits>
#include <utility>

namespace forefront::c {

namespace {

std::string jsonOf(const Diagnostics &faults) {
    JsonWriter json(JsonWriter::Layout::OneLine);
    json.beginArray();
    for (const Diagnostic &fault : faults) {
        json.beginObject();
        json.member("severity", fault.severity == Severity::Error     ? "error"
                                : fault.severity == Severity::Warning ? "warning"
                                                                      : "note");
        json.member("code", fault.code).member("message", fault.message).member("advice", fault.advice);
        if (fault.at) {
            json.key("at").beginArray().value(fault.at->x).value(fault.at->y).endArray();
        } else {
            json.member("at", std::numeric_limits<double>::quiet_NaN()); // null
        }
        json.member("file", fault.file).member("line", fault.line);
        json.endObject();
    }
    return json.endArray().text();
}

bool has(const Diagnostics &faults, const char *code) {
    return !faults.empty() && faults.front().code == code;
}

} // namespace

forefront_status report(forefront_context &context, Diagnostics faults) {
    context.faults = std::move(faults);
    context.message.clear();
    for (const Diagnostic &fault : context.faults) {
        context.message += (context.message.empty() ? "" : "\n") + toString(fault);
    }
    context.json = jsonOf(context.faults);
    while (!context.json.empty() && context.json.back() == '\n') {
        context.json.pop_back();
    }
    if (!hasErrors(context.faults)) {
        return FOREFRONT_OK;
    }
    return has(context.faults, "cancelled")       ? FOREFRONT_CANCELLED
           : has(context.faults, "out-of-memory") ? FOREFRONT_OUT_OF_MEMORY
                                                  : FOREFRONT_REFUSED;
}

forefront_status badArgument(forefront_context &context, const std::string &message) {
    report(context, error("bad-argument", message));
    return FOREFRONT_BAD_ARGUMENT;
}

} // namespace forefront::c

const char *forefront_version(void) {
    return forefront::version();
}

forefront_context *forefront_context_new(void) {
    auto *const context = new (std::nothrow) forefront_context;
    if (context != nullptr && forefront::c::guarded(context, [] { return FOREFRONT_OK; }) != FOREFRONT_OK) {
        delete context;
        return nullptr;
    }
    return context;
}

void forefront_context_free(forefront_context *context) {
    delete context;
}

const char *forefront_message(const forefront_context *context) {
    return context == nullptr ? "" : context->message.c_str();
}

const char *forefront_faults(const forefront_context *context) {
    return context == nullptr ? "[]" : context->json.c_str();
}
