#!/usr/bin/env bash
# Tests that each lint finds planted violations, and passes harmless lookalikes.
#
#   planted.sh words|beginnings|files|flags|layers
#   planted.sh symbols NM COMPILER
#   planted.sh instructions OBJDUMP COMPILER
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
lint=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
tried=0
plant=

finds() { # the command must fail, and its output must have WHAT
  local name=$1 said
  shift
  tried=$((tried + 1))
  if said=$("$@" 2>&1); then
    echo "NOT FOUND: $name $plant"
  elif ! grep -qF -e "$name" <<<"$said"; then
    printf 'NOT SAID: %s %s\n%s\n' "$name" "$plant" "$said"
  else return 0; fi
  failures=$((failures + 1))
}
passes() { # WHAT COMMAND...
  local name=$1 said
  shift
  tried=$((tried + 1))
  if said=$("$@" 2>&1); then return 0; fi
  printf 'WRONGLY FOUND: %s\n%s\n' "$name" "$said"
  failures=$((failures + 1))
}

case $lint in
  words)
    mkdir "$work/core"
    file=$work/core/a.cpp
    while IFS= read -r line; do
      printf 'int harmless;\n%s\n' "$line" >"$file"
      plant=$line
      finds "a.cpp:2:" "$here/words.sh" "$work/core"
    done <"$here/planted_words.txt"
    while IFS=$'\t' read -r word _; do
      case $word in '#'* | '') continue ;; esac
      if ! grep -qE -e "$word" "$here/planted_words.txt"; then
        echo "NOTHING IS PLANTED for $word"
        failures=$((failures + 1))
      fi
    done <"$here/banned_words.txt"
    printf '%s\n' '// std::shuffle, rand()' '/* sin(x)' 'pow(a, b) */ int runtime(int), sometime(int);' \
      'const char* text = "time(0) // exp(1)"; double a = x.time * logNumber(2);' >"$file"
    passes "words in comments, texts and other words" "$here/words.sh" "$work/core"
    finds "there is no source" "$here/words.sh" "$here/allowed_symbols.txt"
    ;;

  files)
    mkdir -p "$work"/runner/{platform/files,platform/system,commands/cli,store}
    while IFS= read -r line; do
      printf 'int harmless;\n%s\n' "$line" >"$work/runner/commands/cli/a.cpp"
      plant=$line
      finds "cli/a.cpp:2:" "$here/files.sh" "$work/runner"
    done <<'PLANTS'
std::ifstream in(file);
std::ofstream(file) << text;
std::fstream both(file);
FILE* f = fopen(name, "rb");
const int f = ::open(name, O_RDONLY);
if (std::filesystem::exists(file)) return;
for (const auto& entry : fs::directory_iterator(folder)) use(entry);
fs::rename(a, b, error);
auto here = std::filesystem::current_path();
::unlink(name);
std::cout << text;
std::cerr << text;
std::clog << text;
fprintf(stderr, text);
printf("%s", text);
fputs(text, stdout);
fmt::print("{}", text);
std::istringstream words(text);
while (getline(in, line)) use(line);
PLANTS
    printf '%s\n' '// std::ifstream, fopen(x), std::cerr' 'namespace fs = std::filesystem;' '#include <filesystem>' \
      'const std::filesystem::path file = fs::path("std::cout") / name; Stored::open(x);' 'fmt::format("x"); database.open();' >"$work/runner/commands/cli/a.cpp"
    echo 'std::ifstream in(::open(x));' >"$work/runner/platform/files/b.cpp"
    echo 'std::cout << text;' >"$work/runner/platform/system/console.cpp"
    plant="in files/"
    echo 'for (const auto& entry : fs::recursive_directory_iterator(folder)) use(entry);' >"$work/runner/platform/files/c.cpp"
    finds "files/c.cpp:1:" "$here/files.sh" "$work/runner"
    rm "$work/runner/platform/files/c.cpp"
    plant=
    passes "comments, texts, paths and the folders that may" "$here/files.sh" "$work/runner"
    finds "there is no source" "$here/files.sh" "$work/runner/store"
    ;;

  beginnings)
    mkdir "$work/core"
    for first in "Of a cell." "Whether it is." "What is left." "The same of a pair." "Those that live." "As above."; do
      plant=$first
      printf 'int a;\n/// %s\nint b;\n' "$first" >"$work/core/a.h"
      finds "a.h:2:" "$here/beginnings.sh" "$work/core"
      printf '  // %s\n' "$first" >"$work/core/a.h"
      finds "a.h:1:" "$here/beginnings.sh" "$work/core"
    done
    plant=
    printf '// Returns the share\n// Of a cell.\nint a; // What is left.\n/// Offers. Asks.\n' >"$work/core/a.h"
    passes "further lines, comments behind code, and other words" "$here/beginnings.sh" "$work/core"
    finds "there is no source" "$here/beginnings.sh" "$work/elsewhere"
    ;;

  flags)
    commands() { # FLAGS
      printf '[\n{\n  "directory": "/b",\n  "command": "c++ -I/r/core %s -o a.o -c /r/core/base/a.cpp",\n  "file": "/r/core/base/a.cpp"\n},\n' "$1"
      printf '{\n  "directory": "/b",\n  "command": "c++ -Ofast -c /r/runner/b.cpp",\n  "file": "/r/runner/b.cpp"\n}\n]\n'
    }
    commands "-O3 -mavx2 -ffp-contract=off -fno-fast-math" >"$work/good.json"
    passes "good options, and bad ones elsewhere" "$here/flags.sh" "$work/good.json" /r/core
    finds "no source" "$here/flags.sh" "$work/good.json" /elsewhere
    for bad in -Ofast -ffast-math -funsafe-math-optimizations -fassociative-math -freciprocal-math -ffinite-math-only \
      -fno-signed-zeros -mfma -mfma4 -march=native -march=haswell -march=x86-64-v3 -mrecip -mfpmath=387 -ffp-model=fast; do
      commands "-O2 -ffp-contract=off $bad" >"$work/bad.json"
      finds "/r/core/base/a.cpp: compiled with $bad" "$here/flags.sh" "$work/bad.json" /r/core
    done
    for bad in "" -ffp-contract=fast -ffp-contract=on "-ffp-contract=off -ffp-contract=fast"; do
      commands "-O2 $bad" >"$work/bad.json"
      finds "/r/core/base/a.cpp: compiled without" "$here/flags.sh" "$work/bad.json" /r/core
    done
    ;;

  layers)
    core=$work/core
    mkdir -p "$core"/{base,mesh,biology,simulation}
    printf '```\nbase ← mesh ← simulation\nbase ← biology ←────── simulation\n```\n' >"$core/README.md"
    sources() { # everything else follows the rules
      echo '#include <vector>' >"$core/base/a.h"
      printf '#include "mesh/b.h"\n#include "base/a.h"\n#include <Eigen/Dense>\n' >"$core/mesh/b.cpp"
      echo '#include "base/a.h"' >"$core/biology/c.h"
      printf '#include "biology/c.h"\n  #include "mesh/b.h"\n' >"$core/simulation/d.h"
      if [ $# -gt 0 ]; then echo "$2" >>"$core/$1"; fi
    }
    sources && passes "downward" "$here/layers.sh" "$core"
    sources base/a.h '#include "mesh/b.h"' && finds "base/a.h:2: base includes" "$here/layers.sh" "$core"
    sources mesh/b.cpp '#  include "biology/c.h"' && finds "mesh/b.cpp:4: mesh includes" "$here/layers.sh" "$core"
    sources biology/c.h '#include "store/e.h"' && finds "biology/c.h:2: biology includes" "$here/layers.sh" "$core"
    sources biology/c.h '#include "c2.h"' && finds "does not say of which folder" "$here/layers.sh" "$core"
    sources simulation/d.h '#include <Eigen/Core>' && finds "<Eigen/Core>: mesh includes Eigen already" "$here/layers.sh" "$core"
    sources && mkdir "$core/attic" && touch "$core/attic/f.h" && finds "attic: a folder" "$here/layers.sh" "$core"
    rm -r "$core/attic"
    # One house lies on another: folders of the lower house are below all folders of the upper one, and not vice versa.
    # Some folders of the upper house are modules with parts.
    runner=$work/runner
    mkdir -p "$runner"/{platform/{files,system},results/{golden,store},long_run,cli}
    printf '```\nplatform ← results ← long_run\nlong_run ← cli\neverywhere: fmt\n```\n' >"$runner/README.md"
    printf '```\nfiles ← system\n```\n' >"$runner/platform/README.md"
    printf '```\ngolden ← store\n```\n' >"$runner/results/README.md"
    upper() { # FILE LINE
      printf '#include <fmt/format.h>\n#include "mesh/b.h"\n' >"$runner/platform/files/g.cpp"
      printf '#include <fmt/format.h>\n#include <yaml-cpp/yaml.h>\n' >"$runner/results/store/h.h"
      printf '#include "files/g.h"\n' >"$runner/platform/system/k.h"
      printf '#include "system/k.h"\n' >"$runner/results/golden/l.h"
      printf '#include "files/g.h"\n' >"$runner/long_run/i.h"
      printf '#include "store/h.h"\n#include "simulation/d.h"\n' >"$runner/cli/j.cpp"
      if [ $# -gt 0 ]; then echo "$2" >>"$runner/$1"; fi
    }
    upper && passes "downward, also by way of others" "$here/layers.sh" "$runner" "$core"
    upper platform/files/g.cpp '#include "long_run/i.h"' && finds "files/g.cpp:3: files includes" "$here/layers.sh" "$runner" "$core"
    upper platform/files/g.cpp '#include "system/k.h"' && finds "system is not below files" "$here/layers.sh" "$runner" "$core"
    upper platform/system/k.h '#include "store/h.h"' && finds "results is not below platform" "$here/layers.sh" "$runner" "$core"
    upper && mkdir "$runner/platform/attic" && touch "$runner/platform/attic/f.h" &&
      finds "platform/attic: a part" "$here/layers.sh" "$runner" "$core"
    rm -r "$runner/platform/attic"
    upper long_run/i.h '#include <yaml-cpp/yaml.h>' && finds "<yaml-cpp/yaml.h>: " "$here/layers.sh" "$runner" "$core"
    upper && finds "mesh is not below files" "$here/layers.sh" "$runner"
    sources mesh/b.cpp '#include "files/g.h"' && finds "mesh/b.cpp:4: mesh includes" "$here/layers.sh" "$core"
    echo "no map" >"$core/README.md" && finds "has no map" "$here/layers.sh" "$core"
    ;;

  symbols)
    nm=$1 compiler=$2
    object() { # debug options prevent inlining
      printf '%s\n' "$1" >"$work/a.cpp" && $compiler -std=c++20 -O0 -fno-builtin -c "$work/a.cpp" -o "$work/a.o"
    }
    object '#include <cmath>
      double f(double x) { return std::sqrt(x); }' && passes "the square root" "$here/symbols.sh" "$nm" "$work/a.o"
    for call in sin cos exp log pow tanh atan2 acos fma cbrt hypot; do
      case $call in pow | atan2 | hypot) arguments='x, x' ;; fma) arguments='x, x, x' ;; *) arguments=x ;; esac
      object "#include <cmath>
        double f(double x) { return std::$call($arguments); }"
      finds "NOT ALLOWED: $call" "$here/symbols.sh" "$nm" "$work/a.o"
    done
    object '#include <cmath>
      float f(float x) { return std::fma(x, x, x); }' && finds "NOT ALLOWED: fmaf" "$here/symbols.sh" "$nm" "$work/a.o"
    object '#include <chrono>
      long f() { return std::chrono::steady_clock::now().time_since_epoch().count(); }'
    finds "NOT ALLOWED: std::chrono" "$here/symbols.sh" "$nm" "$work/a.o"
    object '#include <random>
      unsigned f() { return std::random_device()(); }' && finds "random_device" "$here/symbols.sh" "$nm" "$work/a.o"
    object '#include <random>
      double f(unsigned s) { std::mt19937 e(s); return std::normal_distribution<>()(e); }'
    finds "normal_distribution" "$here/symbols.sh" "$nm" "$work/a.o"
    object '#include <algorithm>
      struct G { using result_type = unsigned; static constexpr unsigned min() { return 0; } static constexpr unsigned max() { return 9; }
        unsigned operator()() { return 3; } };
      void f(int* a, int n) { std::shuffle(a, a + n, G()); }' && finds "shuffle" "$here/symbols.sh" "$nm" "$work/a.o"
    object '#include <unordered_map>
      int f() { std::unordered_map<int, int> m; m[1] = 2; return m.begin()->second; }'
    finds "unordered_map" "$here/symbols.sh" "$nm" "$work/a.o"
    object '#include <ctime>
      long f() { return std::time(nullptr) + std::clock(); }' && finds "NOT ALLOWED: clock" "$here/symbols.sh" "$nm" "$work/a.o"
    object '' && finds "there is no symbol" "$here/symbols.sh" "$nm" "$work/a.o"
    ;;

  instructions)
    objdump=$1 compiler=$2
    case $($compiler -dumpmachine) in
      x86_64*) fused='vfmadd213pd %xmm0, %xmm1, %xmm2;vfnmsub231ss %xmm0, %xmm1, %xmm2;vfmaddsub132pd %xmm0, %xmm1, %xmm2;vfmadd213pd %zmm0, %zmm1, %zmm2'
        approximate='rsqrtps %xmm0, %xmm1;vrcp14pd %zmm0, %zmm1' good='mulpd %xmm0, %xmm1;vaddpd %zmm0, %zmm1, %zmm2;sqrtsd %xmm0, %xmm1' ;;
      aarch64*) fused='fmadd d0, d1, d2, d3;fnmsub s0, s1, s2, s3;fmla v0.2d, v1.2d, v2.2d;fmls v0.4s, v1.4s, v2.4s'
        approximate='frsqrte d0, d1;frecpe d0, d1' good='fmul d0, d1, d2;fadd v0.2d, v1.2d, v2.2d;fsqrt d0, d1' ;;
      *) echo "no plants for $($compiler -dumpmachine)" && exit 77 ;;
    esac
    object() { echo "void f() { asm volatile(\"$1\"); }" >"$work/a.cpp" && $compiler -c "$work/a.cpp" -o "$work/a.o"; }
    while IFS= read -r line; do
      object "$line" && finds "${line%% *}" "$here/instructions.sh" "$objdump" "$work/a.o"
    done < <(tr ';' '\n' <<<"$fused;$approximate")
    object "${good//;/\\n}" && passes "$good" "$here/instructions.sh" "$objdump" "$work/a.o"
    ;;

  *)
    sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
echo "$tried plants, $failures misjudged"
[ $failures = 0 ]
