int TestMapperAgainstReference(int, char*[]) { return 0; }
