// Stands in for libFuzzer where a target is a test: goes through the files of a folder, as they are and altered in ways
// that are the same in every run. An input that takes longer than kPatience_s ends the process, as a crash does; what
// was underway is named then.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;

constexpr int kAltered = 1500;  // in all
constexpr unsigned kPatience_s = 20;
constexpr rlim_t kMostMemory_bytes = rlim_t{3} << 30U;
constexpr std::array<std::uint32_t, 8> kOddNumbers = {0, 1, 0x7F, 0xFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7FF80000};
constexpr std::array<const char*, 12> kOddWords = {"nan", "1e308", "-1", "99999999999", "0",  "",
                                                   "[",   "&a *a", "{}", "- ",          "\n", "\xEF\xBB\xBF"};

std::array<char, 512> underway{};

void tellWhatWasUnderway(int signal) {
  const auto size = ::write(STDERR_FILENO, underway.data(), std::strlen(underway.data()));
  static_cast<void>(size);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  Input alter(Input input, const Input& other) {
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) edit(input, other);
    return input;
  }

 private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

  void edit(Input& input, const Input& other) {
    const std::size_t at = below(input.size() + 1);
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    const auto rest = static_cast<std::size_t>(input.end() - place);
    switch (below(7)) {
      case 0:
        if (rest > 0) *place ^= static_cast<std::uint8_t>(1U << below(8));
        break;
      case 1:
        if (rest > 0) *place = static_cast<std::uint8_t>(below(256));
        break;
      case 2: {
        const std::uint32_t number = kOddNumbers.at(below(kOddNumbers.size()));
        if (rest >= sizeof number) std::memcpy(&*place, &number, sizeof number);
        break;
      }
      case 3:
        input.erase(place, place + static_cast<std::ptrdiff_t>(std::min(rest, 1 + below(16))));
        break;
      case 4:
        input.resize(at);
        break;
      case 5: {
        const std::string word = kOddWords.at(below(kOddWords.size()));
        input.insert(place, word.begin(), word.end());
        break;
      }
      default: {
        const auto from = other.begin() + static_cast<std::ptrdiff_t>(below(other.size()));
        const auto count = static_cast<std::ptrdiff_t>(below(64));
        const Input piece(from, from + std::min(count, static_cast<std::ptrdiff_t>(other.end() - from)));
        input.insert(place, piece.begin(), piece.end());
        break;
      }
    }
  }

  std::mt19937 random_;
};

Input contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void limitMemory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const rlimit limit{kMostMemory_bytes, kMostMemory_bytes};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

void run(const Input& input, const std::filesystem::path& seed, int alteration) {
  std::snprintf(underway.data(), underway.size(), "underway: %s, alteration %d\n", seed.c_str(), alteration);
  alarm(kPatience_s);
  LLVMFuzzerTestOneInput(input.data(), input.size());
  alarm(0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  limitMemory();
  for (const int signal : {SIGALRM, SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, tellWhatWasUnderway);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) {
    std::fprintf(stderr, "%s holds no file to begin with\n", argv[1]);
    return 1;
  }
  std::vector<Input> seeds(files.size());
  std::transform(files.begin(), files.end(), seeds.begin(), contentOf);
  run({}, "nothing", 0);
  for (std::size_t i = 0; i < files.size(); ++i) run(seeds[i], files[i], 0);
  Mutator mutator(1);
  for (int alteration = 1; alteration <= kAltered; ++alteration) {
    const std::size_t i = static_cast<std::size_t>(alteration) % files.size();
    const std::size_t other = (i + static_cast<std::size_t>(alteration) / files.size()) % files.size();
    run(mutator.alter(seeds[i], seeds[other]), files[i], alteration);
  }
  std::printf("%zu files and %d alterations of them\n", files.size(), kAltered);
  return 0;
}
