// Folders, and files in them that are not kept.
#pragma once
#include <string>

namespace netmesh::platform {

// The system's folder for files that are not kept.
std::string system_folder();
// A file of the folder that has no name any more, open for reading and writing; it is gone once nobody has it open.
// -1 with a phrase in *why.
int open_unnamed(const std::string& folder, std::string* why);

// Makes a folder, unless it is there. False with a phrase in *why.
bool make_folder(const std::string& path, std::string* why);
// Makes a folder of a name of its own in the system's for files that are not kept. Empty, with *why, where that fails.
std::string temporary_folder(std::string* why);
// Removes a folder and the files in it, but no folders.
void remove_folder(const std::string& path);

}  // namespace netmesh::platform
