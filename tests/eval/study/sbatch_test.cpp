// Job scripts: what they say, that a shell can read them, and paths that hold blanks and quotes.
#include "eval/study/sbatch.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>

#include "tests/eval/io/temporary_folder.h"

using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

namespace {

SbatchOptions plain_options() {
  SbatchOptions options;
  options.program = "/opt/honka";
  options.scenario = "/data/me/scenarios/robustness/stem_noise.toml";
  options.folder = "/scratch/stem_noise";
  options.working_folder = "/data/me";
  options.shards = 4;
  options.threads = 2;
  return options;
}

SbatchOptions hard_options(const TemporaryFolder& folder) {
  SbatchOptions options = plain_options();
  options.program = folder / "bin of mine/hon'ka";
  options.scenario = folder / "a study.toml";
  options.folder = folder / "out 100% \"x\"";
  options.working_folder = folder.path();
  options.overrides = {"title=It's $HOME"};
  return options;
}

/// What a shell makes of a command line's words, one a line.
std::string words_in_shell(const TemporaryFolder& folder, const std::string& words) {
  write_raw(folder / "words.sh", "printf '%s\\n' " + words + " > " + shell_word(folder / "words"));
  REQUIRE(std::system(("bash " + shell_word(folder / "words.sh")).c_str()) == 0);
  std::ifstream in(folder / "words");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Puts a program in a folder that writes its arguments to `log`, one a line.
void put_program(const std::filesystem::path& program, const std::filesystem::path& log,
                 const std::string& says = "") {
  std::filesystem::create_directories(program.parent_path());
  write_raw(program,
            "#!/bin/sh\nprintf '%s\\n' \"$@\" >> " + shell_word(log.string()) + "\n" + says);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("sbatch: an array of shards that may begin again, a merge behind it") {
  SbatchOptions options = plain_options();
  options.time = "02:00:00";
  options.memory = "8G";
  options.trials = 500;
  options.extra = {"--partition=long", "--account=me"};
  const SbatchScripts scripts = sbatch_scripts(options);
  for (const std::string line :
       {"#!/bin/bash\n", "#SBATCH --array=0-3\n", "#SBATCH --cpus-per-task=2\n",
        "#SBATCH --requeue\n", "#SBATCH --time=02:00:00\n", "#SBATCH --mem=8G\n",
        "#SBATCH --signal=B:TERM@60\n", "#SBATCH --partition=long\n", "#SBATCH --account=me\n",
        "#SBATCH --job-name=honka-stem_noise\n",
        "/opt/honka study /data/me/scenarios/robustness/stem_noise.toml --trials 500 "
        "--shard \"$SLURM_ARRAY_TASK_ID\"/4 --threads \"$SLURM_CPUS_PER_TASK\" "
        "--out /scratch/stem_noise &\n"}) {
    CHECK_THAT(scripts.array, Catch::Contains(line));
  }
  CHECK_THAT(scripts.merge, Catch::Contains("/opt/honka study merge /scratch/stem_noise"));
  CHECK_THAT(scripts.merge, Catch::Contains("#SBATCH --partition=long\n"));
  CHECK_THAT(scripts.merge, !Catch::Contains("--array"));
  CHECK_THAT(scripts.merge, !Catch::Contains("--mem"));
  CHECK_THAT(scripts.submit, Catch::Contains("--dependency=\"afterany:$array\""));
  CHECK_THAT(sbatch_scripts(plain_options()).array, !Catch::Contains("--signal"));
  CHECK(parallel_commands(plain_options()) ==
        "seq 0 3 | parallel -j 1 '/opt/honka study /data/me/scenarios/robustness/stem_noise.toml "
        "--shard {}/4 --threads 2 --out /scratch/stem_noise'\n"
        "/opt/honka study merge /scratch/stem_noise\n");
}

TEST_CASE("sbatch: words keep their blanks, quotes and dollars in a shell") {
  const TemporaryFolder folder;
  for (const std::string word : {"plain", "two words", "it's", "$HOME `ls` \\", "", "*", "a\"b"}) {
    CAPTURE(word);
    CHECK(words_in_shell(folder, shell_word(word)) == word + "\n");
  }
}

TEST_CASE("sbatch: a member runs its shard with the paths as they are, whatever they hold") {
  const TemporaryFolder folder;
  const SbatchOptions options = hard_options(folder);
  put_program(options.program, folder / "log", "exit 5\n");
  write_raw(folder / "array.sbatch", sbatch_scripts(options).array);
  const int status = std::system(
      ("SLURM_ARRAY_TASK_ID=2 SLURM_CPUS_PER_TASK=7 bash " + shell_word(folder / "array.sbatch"))
          .c_str());
  CHECK(WEXITSTATUS(status) == 5);
  CHECK(text_of(folder / "log") ==
        "study\n" + options.scenario.string() +
            "\n-s\ntitle=It's $HOME\n--shard\n2/4\n--threads\n7\n--out\n" +
            options.folder.string() + "\n");
}

TEST_CASE("sbatch: a member that Slurm stops ends its honka and asks for another turn") {
  const TemporaryFolder folder;
  SbatchOptions options = plain_options();
  options.program = folder / "honka";
  // It ends by itself with 3 when told to, as a study does; else after 20 s with 0.
  put_program(options.program, folder / "log",
              "trap 'exit 3' TERM\nkill -TERM $PPID\n"
              "for i in $(seq 200); do sleep 0.1; done\n");
  write_raw(folder / "array.sbatch", sbatch_scripts(options).array);
  const std::string run = "SLURM_ARRAY_TASK_ID=0 SLURM_CPUS_PER_TASK=1 bash ";
  const int stopped = std::system((run + shell_word(folder / "array.sbatch")).c_str());
  CHECK(WEXITSTATUS(stopped) == 75);
  // A full disk (3 without a signal) is no reason to begin again.
  put_program(options.program, folder / "log", "exit 3\n");
  const int full = std::system((run + shell_word(folder / "array.sbatch")).c_str());
  CHECK(WEXITSTATUS(full) == 3);
}

TEST_CASE("sbatch: submitting gives sbatch both scripts, the merge after the array") {
  const TemporaryFolder folder;
  const SbatchOptions options = hard_options(folder);
  put_program(folder / "path/sbatch", folder / "log", "echo '17;cluster'\n");
  write_raw(folder / "submit.sh", sbatch_scripts(options).submit);
  const std::string command = "PATH=" + shell_word(folder / "path") + ":$PATH sh " +
                              shell_word(folder / "submit.sh") + " --array=2 > " +
                              shell_word(folder / "said");
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string scripts = options.folder.string() + "/slurm";
  const std::string logs = (folder / "out 100%% \"x\"/slurm").string();
  CHECK(text_of(folder / "log") == "--parsable\n--output=" + logs + "/shard_%a.log\n--array=2\n" +
                                       scripts + "/array.sbatch\n--parsable\n" +
                                       "--dependency=afterany:17\n--output=" + logs +
                                       "/merge.log\n" + scripts + "/merge.sbatch\n");
  CHECK_THAT(text_of(folder / "said"), Catch::Contains("array job 17, merge job 17"));
}

TEST_CASE("sbatch: a merge that misses shards says how to go on, with its own exit code") {
  const TemporaryFolder folder;
  const SbatchOptions options = hard_options(folder);
  write_raw(folder / "merge.sbatch", sbatch_scripts(options).merge);
  const std::string run =
      "bash " + shell_word(folder / "merge.sbatch") + " > " + shell_word(folder / "said");
  put_program(options.program, folder / "log", "[ \"$2\" != merge ] || exit 2\n");
  CHECK(WEXITSTATUS(std::system(run.c_str())) == 2);
  CHECK_THAT(text_of(folder / "said"), Catch::Contains("To run what is missing"));
  CHECK_THAT(text_of(folder / "log"), Catch::Contains("study\nstatus\n"));
  put_program(options.program, folder / "log");
  CHECK(std::system(run.c_str()) == 0);
  CHECK(text_of(folder / "said").empty());
}

TEST_CASE("sbatch: options that no job script can hold are refused") {
  const auto complaint = [](auto change) {
    SbatchOptions options = plain_options();
    change(options);
    return user_error_of([&] { (void)sbatch_scripts(options); });
  };
  CHECK_THAT(complaint([](auto& o) { o.shards = 0; }), Catch::Contains("--shards: 0"));
  CHECK_THAT(complaint([](auto& o) { o.threads = 0; }), Catch::Contains("--threads: 0"));
  CHECK_THAT(complaint([](auto& o) { o.time = "two hours"; }), Catch::Contains("--time"));
  CHECK_THAT(complaint([](auto& o) { o.memory = "8 G"; }), Catch::Contains("--memory"));
  CHECK_THAT(complaint([](auto& o) { o.extra = {"partition"}; }), Catch::Contains("--extra"));
  CHECK_THAT(complaint([](auto& o) { o.extra = {"--x\nrm"}; }), Catch::Contains("--extra"));
}
