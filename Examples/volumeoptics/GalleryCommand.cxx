#include "Commands.h"
void AddGalleryCommand(CLI::App&) {}
