"""The reference server's contact physics: the law of src/dynamics/DYNAMICS.md, added up in the order of src/dynamics/ORDER.md."""
