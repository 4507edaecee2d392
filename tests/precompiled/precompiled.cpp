// Nothing: its target holds the headers that nearly all tests include, parsed once (tests/CMakeLists.txt).
