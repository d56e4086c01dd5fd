#include "core/teaching/page/run_page.hpp"

#include "core/teaching/page/player.hpp"
#include "core/teaching/page/recorded_run.hpp"

namespace forefront {

Result<WrittenRunPage> writeRunPage(const MeshingJob &job, const RunPagePlan &plan, TextWriter &out,
                                    const Progress &progress) {
    const Result<RecordedRun> run = recordRun(job, plan, progress);
    if (!run) {
        return run.faults();
    }
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"Forefront\">\n<title>"
        << htmlText(plan.title) << "</title>\n<style>\n"
        << playerStyle() << "</style>\n</head>\n<body>\n"
        << playerBody() << "<script type=\"application/json\" id=\"run\">\n";
    writeRun(out, *run, plan.title, plan.from);
    out << "\n</script>\n<script>\n" << playerScript() << "</script>\n</body>\n</html>\n";
    return WrittenRunPage{run->advances.size(), run->complete};
}

} // namespace forefront
