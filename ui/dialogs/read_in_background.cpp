#include "ui/dialogs/read_in_background.hpp"

#include "ui/dialogs/tab_commands.hpp"
#include "ui/parts/shell.hpp"

#include <new>
#include <utility>

namespace forefront {

namespace {

/// Returns the function that reports an unreadable file.
BackgroundTask::Finish refusal(Shell &context, const std::shared_ptr<FileOutcome> &outcome, Diagnostics faults) {
    return [&context, outcome, refused = std::move(faults)] {
        if (outcome) {
            *outcome = {.done = true, .faults = refused};
        } else {
            context.log.add(refused);
        }
    };
}

} // namespace

void readInBackground(Shell &context, const std::filesystem::path &file, const std::shared_ptr<FileOutcome> &outcome,
                      FileReader read) {
    cancelTask(context);
    context.task.start("reading " + file.filename().string(),
                       [&context, outcome, reader = std::move(read)](const Progress &progress) {
                           try {
                               const Result<BackgroundTask::Finish> use = reader(progress);
                               if (progress.cancelled()) {
                                   return BackgroundTask::Finish();
                               }
                               if (!use) {
                                   return refusal(context, outcome, use.faults());
                               }
                               return BackgroundTask::Finish([outcome, finish = *use] {
                                   if (outcome) {
                                       outcome->done = true;
                                   }
                                   finish();
                               });
                           } catch (const std::bad_alloc &) {
                               return refusal(context, outcome,
                                              error("out-of-memory", "not enough memory to open the file",
                                                    "close other programs, or open a smaller file"));
                           }
                       });
    context.animate();
}

bool replacedWhileReading(Shell &context, const std::filesystem::path &file, std::uint64_t loads) {
    if (showTabWith(context, loads)) { // another tab may have been shown since
        return false;
    }
    context.log.refuse(file.filename().string() + " is not shown: another document was opened while it was read");
    return true;
}

} // namespace forefront
