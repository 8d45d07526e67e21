# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The discs at the end of the packing run as the table that the collapse starts from: packing/writeTable.py table"""

import sys

from foamCase import CaseFolder

HEAD = """# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
# The packed column, made by packing: x y z d [m]
"""


def main():
    case = CaseFolder("packing")
    with open(sys.argv[1], "w") as file:
        file.write(HEAD)
        for (x, y, _), d in zip(case.cloud("position"), case.cloud("d")):
            file.write("%.8g %.8g 0 %.8g\n" % (x, y, d))


main()
