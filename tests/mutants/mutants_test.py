"""What mutants.py does, on a project of one function."""

import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from mutations import mutations_of

TOOL = Path(__file__).with_name("mutants.py")

PROJECT = """
cmake_minimum_required(VERSION 3.22)
project(small LANGUAGES CXX)
enable_testing()
add_library(rob_lang STATIC lang/sign.cpp)
add_executable(lang_test tests/sign_test.cpp)
target_link_libraries(lang_test rob_lang)
add_test(NAME cli_test COMMAND lang_test)
"""
# From outside all layers are tested together.
TWO_LAYERS = """
add_library(rob_motion STATIC motion/sign.cpp)
add_executable(motion_test tests/motion_sign_test.cpp)
target_link_libraries(motion_test rob_motion)
add_test(NAME runtime_test COMMAND sh -c "$<TARGET_FILE:lang_test> && $<TARGET_FILE:motion_test>")
add_test(NAME programs/all COMMAND sh -c "$<TARGET_FILE:lang_test> && $<TARGET_FILE:motion_test>")
"""
SIGN = """// The sign: x < 0 is told by true.
bool negative(int x) {
  return x < 0 && x != 0;
}
"""
GOOD = """
bool negative(int x);
int main() { return negative(-3) && !negative(0) && !negative(3) ? 0 : 1; }
"""
ASKS_NOTHING = "int main() {}\n"
HANGS = "#include <unistd.h>\nint main() { for (;;) pause(); }\n"


def made(line):
    """The lines that mutations make of one."""
    return {mutation.apply(line) for mutation in mutations_of(line)}


class Mutations(unittest.TestCase):
    def test_operators_are_turned(self):
        self.assertEqual(made("a = b < c;\n"), {"a = b >= c;\n"})
        self.assertEqual(made("a = b + c;\n"), {"a = b - c;\n"})
        self.assertEqual(made("a = b && c;\n"), {"a = b || c;\n"})
        self.assertEqual(made("a -= b / c;\n"), {"a += b / c;\n", "a -= b * c;\n"})

    def test_signs_truths_and_constants(self):
        self.assertEqual(made("return -x;\n"), {"return x;\n"})
        self.assertEqual(made("a = true;\n"), {"a = false;\n"})
        self.assertEqual(made("a = b[1];\n"), {"a = b[2];\n"})
        self.assertEqual(made("f(7, 0.5);\n"), {"f(14, 0.5);\n", "f(7, 1.0);\n"})

    def test_conditions_and_calls(self):
        self.assertEqual(made("if (f(a)) b;\n"), {"if (!(f(a))) b;\n"})
        self.assertEqual(made("a = !b;\n"), {"a = b;\n"})
        self.assertEqual(made("x;\n  file.close();\n"), {"x;\n  {}\n"})
        self.assertEqual(made("x;\n  return f();\n"), set())

    def test_what_is_no_code_or_no_promise_stays(self):
        for line in (
            "// a < b && true\n",
            'const char* const text = "1 + 1 < 3";\n',
            "#include <a/b.h>\n#if 1 < 2\n",
            "/* a + b\n   c && d */\n",
            "  assert(a == b && c);\n",
            "static_assert(1 + 1 == 2);\n",
            "std::array<double, 6> a;\n",
            "constexpr double kClose = 1e-12;\n",
            "constexpr int kMost = 500;  // [choice]\n",
            "// [choice] as long as\n// it is short\nconstexpr int kMost = 500;\n",
            "  names.reserve(count);\n",
            "T* a; T& b = f(*c, &d);\n",
        ):
            self.assertEqual(made("x;\n" + line), set(), line)


class Hunt(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in ("lang", "tests"):
            (self.root / name).mkdir()
        self.write("CMakeLists.txt", PROJECT)
        self.write("lang/sign.cpp", SIGN)

    def write(self, name, text):
        (self.root / name).write_text(text)

    def tree(self):
        """All files but those of the copy."""
        files = (file for file in self.root.rglob("*") if file.is_file())
        return {
            str(file): file.read_bytes()
            for file in files
            if file.relative_to(self.root).parts[0] != "build-mutants"
        }

    def start(self, count):
        return subprocess.Popen(
            [sys.executable, TOOL, str(count), "--root", self.root],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )  # fmt: skip

    def hunt(self, count):
        process = self.start(count)
        out, _ = process.communicate(timeout=100)
        return process.returncode, out

    def test_those_that_a_test_finds_die(self):
        self.write("tests/sign_test.cpp", GOOD)
        before = self.tree()
        code, out = self.hunt(2)
        self.assertEqual((code, out.count(" died (folder) lang/sign.cpp:3")), (0, 2), out)
        self.assertIn("2 of 2 mutants died (100 %), seed 1", out)
        self.assertEqual(self.tree(), before)

    def test_a_layer_is_tried_without_the_mutants_of_another(self):
        (self.root / "motion").mkdir()
        self.write("CMakeLists.txt", PROJECT + TWO_LAYERS)
        sign = SIGN.replace(" && x != 0", "")  # of one mutation
        self.write("lang/sign.cpp", sign)
        self.write("motion/sign.cpp", sign.replace("negative", "backwards"))
        self.write("tests/sign_test.cpp", GOOD)
        self.write("tests/motion_sign_test.cpp", GOOD.replace("negative", "backwards"))
        code, out = self.hunt(2)
        self.assertEqual(code, 0, out)
        for layer in ("lang", "motion"):
            self.assertIn(f" died (folder) {layer}/sign.cpp:3", out)

    def test_those_that_no_test_finds_are_shown(self):
        self.write("tests/sign_test.cpp", ASKS_NOTHING)
        code, out = self.hunt(1)
        self.assertEqual(code, 1, out)
        self.assertRegex(out, r"SURVIVED lang/sign.cpp:3\n    - return x < 0 && x != 0;\n    \+ return")
        self.assertIn("0 of 1 mutants died (0 %), seed 1", out)

    def test_tests_that_fail_without_a_mutant_are_an_error(self):
        self.write("tests/sign_test.cpp", "int main() { return 1; }\n")
        code, out = self.hunt(1)
        self.assertEqual(code, 2, out)
        self.assertIn("the tests of lang fail without a mutant", out)

    def test_an_abort_leaves_nothing_that_runs_and_the_sources_as_they_were(self):
        self.write("tests/sign_test.cpp", HANGS)
        before = self.tree()
        process = self.start(1)
        test = self.root / "build-mutants/build/lang_test"
        self.assertTrue(self.eventually(lambda: self.runs(test)))
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=20)
        self.assertEqual(process.returncode, 128 + signal.SIGINT)
        self.assertTrue(self.eventually(lambda: not self.runs(test)))
        self.assertEqual(self.tree(), before)

    @staticmethod
    def runs(program):
        for entry in Path("/proc").glob("[0-9]*/exe"):
            try:
                if os.readlink(entry) == str(program):
                    return True
            except OSError:
                continue  # it has just ended
        return False

    @staticmethod
    def eventually(condition):
        until = time.monotonic() + 60
        while time.monotonic() < until and not condition():
            time.sleep(0.05)
        return condition()


if __name__ == "__main__":
    unittest.main()
