#include "runtime/cli/run_rob.h"

int main(int argc, char** argv) { return rob::runtime::run_rob(argc, argv, nullptr); }
