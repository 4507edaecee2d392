"""Makes the Debian package and checks what is in it.

usage: check_package.py CPACK CONFIGURATION FOLDER PROGRAM...
"""
import pathlib
import shutil
import subprocess
import sys


def contents_of(package):
    listing = subprocess.run(["dpkg-deb", "-c", package], capture_output=True, text=True, check=True).stdout
    return {line.split()[5].removeprefix("./") for line in listing.splitlines()}


def fields_of(package):
    text = subprocess.run(["dpkg-deb", "-f", package], capture_output=True, text=True, check=True).stdout
    return dict(line.split(": ", 1) for line in text.splitlines() if not line.startswith(" ") and ": " in line)


def expected_files(programs):
    yield from ("usr/share/doc/wardslam/copyright", "usr/share/doc/wardslam/changelog.gz",
                "usr/share/wardslam/config/wardslam.yaml", "usr/share/wardslam/models.yaml",
                "usr/share/wardslam/networks/depth_hospital.onnx", "usr/share/wardslam/networks/depth_hospital.yaml",
                "usr/lib/cmake/wardslam/wardslam-config.cmake", "usr/include/wardslam/pipeline/slam_system.h",
                "usr/lib/wardslam/libwardslam-mrpt.so", "usr/share/bash-completion/completions/wardslam")
    for program in programs:
        yield f"usr/bin/{program}"
        yield f"usr/share/man/man1/{program}.1.gz"


def check(cpack, configuration, folder, programs):
    shutil.rmtree(folder, ignore_errors=True)
    made = subprocess.run([cpack, "--config", configuration, "-B", folder], capture_output=True, text=True)
    packages = list(pathlib.Path(folder).glob("*.deb"))
    if made.returncode != 0 or len(packages) != 1:
        return [made.stdout + made.stderr]
    contents = contents_of(packages[0])
    fields = fields_of(packages[0])
    complaints = [f"{file} is missing" for file in expected_files(programs) if file not in contents]
    complaints += [f"{file} is not below usr/" for file in contents if file and not file.startswith("usr/")]
    for field, part in (("Package", "wardslam"), ("Section", "science"), ("Description", "SLAM"),
                        ("Depends", "libmrpt-obs"), ("Depends", "libopencv-core"), ("Depends", "libpcl")):
        if part not in fields.get(field, ""):
            complaints.append(f"{field}: {fields.get(field)} does not name {part}")
    shutil.rmtree(folder)
    return complaints


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    if shutil.which("dpkg-shlibdeps") is None:
        print("skipped: there is no dpkg-shlibdeps here")
        sys.exit(0)
    found = check(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:])
    print("\n".join(found))
    sys.exit(1 if found else 0)
