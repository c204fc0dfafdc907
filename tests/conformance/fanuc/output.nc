(POPEN, DPRNT, BPRNT: MB-235 to MB-253.)

(CASE MB-237 literal characters; blanks of the source are dropped)
%
O1
POPEN
DPRNT[ABC XYZ 019+-/]
PCLOS
M30
%
(EXPECT OUTPUT "ABCXYZ019+-/\n")

(CASE MB-237 an empty format ends the line only)
%
O1
POPEN
DPRNT[]
DPRNT[A]
PCLOS
M30
%
(EXPECT OUTPUT "\nA\n")

(CASE MB-238 an asterisk is a blank)
%
O1
POPEN
DPRNT[A*B**C]
PCLOS
M30
%
(EXPECT OUTPUT "A B  C\n")

(CASE MB-240 sign first, then blanks, then digits)
(PARAMETER 6001.1 = 0)
%
O1
#1=-123.456
POPEN
DPRNT[#1[44]]
PCLOS
M30
%
(EXPECT OUTPUT "- 123.4560\n")

(CASE MB-240 a positive sign is a blank)
(PARAMETER 6001.1 = 0)
%
O1
#1=128.47398
POPEN
DPRNT[#1[53]]
PCLOS
M30
%
(EXPECT OUTPUT "   128.474\n")

(CASE MB-240 a negative one stands at the left)
(PARAMETER 6001.1 = 0)
%
O1
#1=-91.2
POPEN
DPRNT[#1[53]]
PCLOS
M30
%
(EXPECT OUTPUT "-   91.200\n")

(CASE MB-240 without decimals there is no point)
(PARAMETER 6001.1 = 0)
%
O1
#1=7
POPEN
DPRNT[#1[30]]
PCLOS
M30
%
(EXPECT OUTPUT "   7\n")

(CASE MB-241 6001.1 leaves blanks out)
(PARAMETER 6001.1 = 1)
%
O1
#1=-123.456
POPEN
DPRNT[#1[44]]
PCLOS
M30
%
(EXPECT OUTPUT "-123.4560\n")

(CASE MB-241 and the plus sign)
(PARAMETER 6001.1 = 1)
%
O1
#1=128.47398
POPEN
DPRNT[#1[53]]
PCLOS
M30
%
(EXPECT OUTPUT "128.474\n")

(CASE MB-242 a zero before the point is printed)
(PARAMETER 6001.1 = 0)
%
O1
#1=0.056
POPEN
DPRNT[#1[20]]
PCLOS
M30
%
(EXPECT OUTPUT "  0\n")

(CASE MB-242 and kept in front of decimals)
(PARAMETER 6001.1 = 0)
%
O1
#1=0.5
POPEN
DPRNT[#1[23]]
PCLOS
M30
%
(EXPECT OUTPUT "  0.500\n")

(CASE MB-242 but not without integer places)
(PARAMETER 6001.1 = 0)
%
O1
#1=-0.456
POPEN
DPRNT[#1[02]]
PCLOS
M30
%
(EXPECT OUTPUT "-.46\n")

(CASE MB-243 digits above the field are dropped)
(PARAMETER 6001.1 = 0)
%
O1
#1=123.456
POPEN
DPRNT[#1[22]]
PCLOS
M30
%
(EXPECT OUTPUT " 23.46\n")

(CASE MB-243 with 6001.1 too)
(PARAMETER 6001.1 = 1)
%
O1
#1=123.456
POPEN
DPRNT[#1[22]]
PCLOS
M30
%
(EXPECT OUTPUT "23.46\n")

(CASE MB-244 decimals are rounded)
(PARAMETER 6001.1 = 0)
%
O1
#1=1.005001
POPEN
DPRNT[#1[32]]
PCLOS
M30
%
(EXPECT OUTPUT "   1.01\n")

(CASE MB-239 decimals are always printed)
(PARAMETER 6001.1 = 0)
%
O1
#1=2.5
POPEN
DPRNT[#1[32]]
PCLOS
M30
%
(EXPECT OUTPUT "   2.50\n")

(CASE MB-245 a zero that operations come to has no sign)
%
O1
#1=0*[-1]
#2=-#3+0
#4=5-5
#5=FIX[-.5]
#6=ROUND[-.4]
#7=0/[-2]
POPEN
DPRNT[A#1[13]B#2[13]C#5[13]D#6[13]E#7[13]]
#8=-#4
DPRNT[F#8[13]]
PCLOS
M30
%
(EXPECT OUTPUT "A 0.000B 0.000C 0.000D 0.000E 0.000\nF 0.000\n")

(CASE MB-245 what rounds to zero keeps its sign)
(PARAMETER 6001.1 = 0)
%
O1
#1=-0.01
POPEN
DPRNT[#1[31]]
PCLOS
M30
%
(EXPECT OUTPUT "-  0.0\n")

(CASE MB-239 text and several variables)
%
O1
#1=1.5
#2=-22.25
POPEN
DPRNT[X#1[33]*Y#2[33]**T#100[20]]
PCLOS
M30
%
(EXPECT OUTPUT "X   1.500 Y- 22.250  T  0\n")

(CASE MB-239 nine places on the 30i)
(CONTROL fanuc-30i)
%
O1
#1=12345.6789
POPEN
DPRNT[#1[54]]
PCLOS
M30
%
(EXPECT OUTPUT " 12345.6789\n")

(CASE MB-239 nine places are too many for the 16i)
(CONTROL fanuc-16i)
%
O1
#1=1
POPEN
DPRNT[#1[54]]
PCLOS
M30
%
(EXPECT ALARM FORMAT AT 6)

(CASE MB-247 6001.4 ends lines with LF CR)
(PARAMETER 6001.4 = 1)
%
O1
POPEN
DPRNT[A]
PCLOS
M30
%
(EXPECT OUTPUT "A\n\r")

(CASE MB-248 BPRNT)
%
O1
#1=0.40596
#2=-1638.4
#3=258.64767
POPEN
BPRNT[A#1[3]B#2[3]]
BPRNT[#3[3]]
PCLOS
M30
%
(EXPECT OUTPUT "A\x00\x00\x01\x96B\xFF\xE7\x00\x00\n\x00\x03\xF2\x58\n")

(CASE MB-236 POPEN and PCLOS may stand in different programs)
%
O1
M98 P9500
DPRNT[A]
M98 P9501
M30
O9500
POPEN
M99
O9501
PCLOS
M99
%
(EXPECT OUTPUT "A\n")

(CASE MB-249 without POPEN it prints all the same)
%
O1
DPRNT[A]
M30
%
(EXPECT OUTPUT "A\n")

(CASE MB-253 no computed variables in a format)
%
O1
POPEN
DPRNT[#[#100][10]]
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE MB-253 no computed digits)
%
O1
POPEN
DPRNT[#100[#1]]
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE MB-246 a vacant local variable)
%
O1
POPEN
DPRNT[#3[42]]
PCLOS
M30
%
(EXPECT OUTPUT "    0.00\n")

(CASE MB-249 without POPEN there is a remark)
%
O1
DPRNT[A]
POPEN
DPRNT[B]
PCLOS
M30
%
(EXPECT OUTPUT "A\nB\n")
(EXPECT WARNING PRB308 AT 3)
