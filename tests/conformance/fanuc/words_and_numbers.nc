(Numbers in words and words in blocks: MB-020 to MB-033.)

(CASE MB-020 without a point a number counts least increments)
%
O1
G0 X1000 Y1000. Z-5
M30
%
(EXPECT MOVE 1 X1 Y1000 Z-0.005)

(CASE MB-020 parameter 3401.0 makes it count millimetres)
(PARAMETER 3401.0 = 1)
%
O1
G0 X1000 Y10.
M30
%
(EXPECT MOVE 1 X1000 Y10)

(CASE MB-021 least increments of IS-C are a tenth)
(SETTING increment = "IS-C")
%
O1
G0 X1000
M30
%
(EXPECT MOVE 1 X0.1)

(CASE MB-021 a tenth of a thousandth inch)
%
O1
G20
G0 X10000
#100=#5001
M30
%
(EXPECT #100 = 1)

(CASE MB-022 a variable is a value with a point)
%
O1
#100=10
G0 X#100 Y10
M30
%
(EXPECT MOVE 1 X10 Y0.01)

(CASE MB-023 substituted values are rounded to the increment, halves away from zero)
%
O1
#1=12.3456
#2=1.2345
#3=-1.2345
G0 X#1 Y#2 Z#3
#101=#5001
#102=#5002
#103=#5003
M30
%
(EXPECT #101 = 12.346 WITHIN 0.0000001)
(EXPECT #102 = 1.235 WITHIN 0.0000001)
(EXPECT #103 = -1.235 WITHIN 0.0000001)

(CASE MB-023 and to a ten-thousandth of a millimetre under IS-C)
(SETTING increment = "IS-C")
%
O1
#1=12.34567
G0 X#1
#101=#5001
M30
%
(EXPECT #101 = 12.3457 WITHIN 0.0000001)

(CASE MB-024 the 16i cuts a literal off)
(CONTROL fanuc-16i)
%
O1
G0 X1.2345 Y-1.2349
#101=#5001
#102=#5002
M30
%
(EXPECT #101 = 1.234 WITHIN 0.0000001)
(EXPECT #102 = -1.234 WITHIN 0.0000001)

(CASE MB-025 S with a point)
%
O1
S1000.0
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 M with a point)
%
O1
M3.0
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 T with a point)
%
O1
T5.
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 H with a point)
%
O1
G43 H1.
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 D with a point)
%
O1
D1.
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 N with a point)
%
O1
N10. G0
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 P of a call with a point)
%
O1
G65 P9500.
M30
%
(EXPECT ALARM 7 AT 3)

(CASE MB-025 L of a call with a point)
%
O1
G65 P9500 L2.
M30
O9500
M99
%
(EXPECT ALARM 7 AT 3)

(CASE MB-026 substituted integers are rounded)
%
O1
S[1000.4999]
#101=#4119
S[1000.5]
#102=#4119
#1=3.5
M#1
#103=#4113
#2=7.4
T#2
#104=#4120
M30
%
(EXPECT #101 = 1000)
(EXPECT #102 = 1001)
(EXPECT #103 = 4)
(EXPECT #104 = 7)

(CASE MB-026 a G word takes an exact integer)
%
O1
#27=91
#1=1
G#27 G#1 X5. F100.
#101=#4001
#102=#4003
M30
%
(EXPECT #101 = 1)
(EXPECT #102 = 91)

(CASE MB-027 more than eight digits on the 16i)
(CONTROL fanuc-16i)
%
O1
#1=0.00000001
M30
%
(EXPECT ALARM 3 AT 4)

(CASE MB-027 eight digits behind a bare point are legal)
%
O1
#100=.00000001
M30
%
(EXPECT #100 = 0.00000001 WITHIN 0.0000000000001)

(CASE MB-027 nine digits in a word of the 16i)
(CONTROL fanuc-16i)
%
O1
G0 X123456.789
M30
%
(EXPECT ALARM 3 AT 4)

(CASE MB-027 twelve digits of a macro constant on the 30i)
(CONTROL fanuc-30i)
%
O1
#100=123456.789012
M30
%
(EXPECT #100 = 123456.789012 WITHIN 0.0000001)

(CASE MB-027 ten digits in a word of the 30i)
(CONTROL fanuc-30i)
%
O1
G0 X1234567.890
M30
%
(EXPECT ALARM 3 AT 4)

(CASE MB-028 signs before variables and brackets)
%
O1
#1=2
G0 X-#1 Y+#1 Z-[#1+1]
M30
%
(EXPECT MOVE 1 X-2 Y2 Z-3)

(CASE MB-029 an expression in a word needs brackets)
%
O1
#1=1
#2=2
G0 X[#1+#2]
M30
%
(EXPECT MOVE 1 X3)

(CASE MB-029 without them it is a format error)
(CONTROL fanuc-16i)
%
O1
#1=1
G0 X#1+10
M30
%
(EXPECT ALARM FORMAT AT 5)

(CASE MB-030 in an assignment the point means nothing)
(PARAMETER 3401.0 = 0)
%
O1
#100=123
#101=123.
M30
%
(EXPECT #100 = 123)
(EXPECT #101 = 123)

(CASE MB-031 positions and offsets are in the unit in force, plain variables keep theirs)
%
O1
G21
#100=25.4
#5221=25.4
G0 X50.8
G20
#101=#5221
#102=#5021
#103=#100
M30
%
(EXPECT #101 = 1)
(EXPECT #102 = 3)
(EXPECT #103 = 25.4)

(CASE MB-033 no variable behind O)
%
O#1
M30
%
(EXPECT ALARM FORMAT AT 2)

(CASE MB-033 no variable behind N)
%
O1
#1=10
N#1 G0
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE MB-032 a substituted value must be legal for its address)
(PARAMETER 3030 = 3)
%
O1
#30=1100
M#30
M30
%
(EXPECT ALARM 3 AT 5)

(CASE MB-032 M counts from 0)
%
O1
#30=-1
M#30
M30
%
(EXPECT ALARM 6 AT 4)

(CASE MB-032 S counts from 0)
%
O1
#30=-1
S#30
M30
%
(EXPECT ALARM 6 AT 4)

(CASE MB-032 T counts from 0)
%
O1
#30=-1
T#30
M30
%
(EXPECT ALARM 6 AT 4)

(CASE MB-032 with as many digits as the address takes)
(PARAMETER 3030 = 3)
(PARAMETER 3031 = 5)
%
O1
#30=110
M#30
S[#30*100]
M30
%
(EXPECT COMPLETED)
