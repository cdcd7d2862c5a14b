#include "sim_bridge/commands/command.h"

int main(int argc, char** argv) { return seaway::bridge::runCommandLine(argc, argv); }
