#include "Commands.h"
void AddTradeCommand(CLI::App&) {}
