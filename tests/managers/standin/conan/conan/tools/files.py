import fnmatch
import os
import shutil


def copy(conanfile, pattern, src, dst):
    for name in fnmatch.filter(os.listdir(src), pattern):
        os.makedirs(dst, exist_ok=True)
        shutil.copy(os.path.join(src, name), dst)
