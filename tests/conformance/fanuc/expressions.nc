(Operators, numbers and brackets: MB-040 to MB-049, MB-067, MB-068, MB-073 to MB-077.)

(CASE MB-041 functions, then * / AND MOD, then + - OR XOR)
%
O1
#100=1 OR 2 AND 4
#101=7 AND 3+8
#102=1+2 XOR 1
#103=2+3*4
#104=12/2*3
#105=7 MOD 4*2
#106=6 OR 1+8
#107=10-SQRT[16]*2
#108=15 AND 6 MOD 4
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 11)
(EXPECT #102 = 2)
(EXPECT #103 = 14)
(EXPECT #104 = 18)
(EXPECT #105 = 6)
(EXPECT #106 = 15)
(EXPECT #107 = 2)
(EXPECT #108 = 2)

(CASE MB-042 equal precedence goes from left to right)
%
O1
#100=10-4-3
#101=100/10/5
#102=8 XOR 3-1
#103=2-1 OR 4
M30
%
(EXPECT #100 = 3)
(EXPECT #101 = 2)
(EXPECT #102 = 10)
(EXPECT #103 = 5)

(CASE MB-043 five brackets, those of a function and of a computed number too)
%
O1
#7=7
#100=[[[[[7]]]]]
#101=SQRT[[[[[16]]]]]
#102=#[[[[[7]]]]]
IF[[[[[1]]]]EQ1]THEN #103=1
M30
%
(EXPECT #100 = 7)
(EXPECT #101 = 4)
(EXPECT #102 = 7)
(EXPECT #103 = 1)

(CASE MB-043 six brackets)
%
O1
#100=[[[[[[7]]]]]]
M30
%
(EXPECT ALARM 118 AT 3)

(CASE MB-043 the bracket of a function counts)
%
O1
#100=ABS[[[[[[7]]]]]]
M30
%
(EXPECT ALARM 118 AT 3)

(CASE MB-043 function brackets to the fifth)
%
O1
#100=ABS[ABS[ABS[ABS[ABS[-7]]]]]
M30
%
(EXPECT #100 = 7)

(CASE MB-043 six brackets of a computed number)
%
O1
#101=#[[[[[[7]]]]]]
M30
%
(EXPECT ALARM 118 AT 3)

(CASE MB-043 six brackets of IF)
%
O1
IF[[[[[[1]]]]]EQ1]THEN #101=1
M30
%
(EXPECT ALARM 118 AT 3)

(CASE MB-043 brackets side by side do not add up)
%
O1
#100=[1+[2]]*[3+[4]]+[[[[5]]]]
M30
%
(EXPECT #100 = 26)

(CASE MB-044 numbers with and without digits on one side)
%
O1
#100=.5
#101=5.
#102=-.25
M30
%
(EXPECT #100 = 0.5)
(EXPECT #101 = 5)
(EXPECT #102 = -0.25)

(CASE MB-044 there is no exponent form, E3 is a word)
%
O1
#100=1E3
M30
%
(EXPECT ALARM 127 AT 3)

(CASE MB-044 two points)
%
O1
#100=1.2.3
M30
%
(EXPECT ALARM FORMAT AT 3)

(CASE MB-046 fifteen digits on the 30i)
(CONTROL fanuc-30i)
%
O1
#100=0.1+0.2-0.3
#101=123456789.*1000.+1.-123456789000.
M30
%
(EXPECT #100 = 0 WITHIN 0.000000000000001)
(EXPECT #101 = 1 WITHIN 0.00001)

(CASE MB-047 beyond 1e47 on the 16i)
(CONTROL fanuc-16i)
%
O1
#1=99999999.
#2=#1*#1*#1*#1*#1
#100=1
#3=#2*#1
M30
%
(EXPECT #100 = 1)
(EXPECT ALARM 111 AT 7)

(CASE MB-047 underflow too)
(CONTROL fanuc-16i)
%
O1
#1=.00000001
#2=#1*#1*#1
#100=1
#3=#2*#1
M30
%
(EXPECT #100 = 1)
(EXPECT ALARM 111 AT 7)

(CASE MB-047 underflow by division)
(CONTROL fanuc-16i)
%
O1
#1=.00000001
#2=#1*#1*#1
#3=#2/99999999.
M30
%
(EXPECT ALARM 111 AT 6)

(CASE MB-047 the 30i goes on)
(CONTROL fanuc-30i)
%
O1
#1=99999999.
#2=#1*#1*#1*#1*#1*#1*#1*#1
#3=.00000001*.00000001*.00000001*.00000001
#100=1
M30
%
(EXPECT #100 = 1)

(CASE MB-047 and ends where a double ends)
(CONTROL fanuc-30i)
%
O1
#1=99999999.
#2=#1*#1*#1*#1*#1*#1*#1*#1
#3=#2*#2*#2*#2
#100=1
#4=#3*#2
M30
%
(EXPECT #100 = 1)
(EXPECT ALARM 111 AT 8)

(CASE MB-049 division by zero)
%
O1
#1=1/0
M30
%
(EXPECT ALARM 112 AT 3)

(CASE MB-049 zero by zero)
%
O1
#1=0/0
M30
%
(EXPECT ALARM 112 AT 3)

(CASE MB-049 division by a vacant variable)
%
O1
#1=5/#2
M30
%
(EXPECT ALARM 112 AT 3)

(CASE MB-049 in a word)
%
O1
G0 X[1/#0]
M30
%
(EXPECT ALARM 112 AT 3)

(CASE MB-067 MOD rounds its operands and has the sign of the dividend)
%
O1
#100=27 MOD 20
#101=10.6 MOD 4
#102=-7 MOD 3
#103=7 MOD[-3]
#104=6 MOD 3
M30
%
(EXPECT #100 = 7)
(EXPECT #101 = 3)
(EXPECT #102 = -1)
(EXPECT #103 = 1)
(EXPECT #104 = 0)

(CASE MB-067 MOD by zero)
%
O1
#1=5 MOD 0
M30
%
(EXPECT ALARM 112 AT 3)

(CASE MB-067 MOD by what rounds to zero)
%
O1
#1=5 MOD 0.4
M30
%
(EXPECT ALARM 112 AT 3)

(CASE MB-068 AND OR XOR bit by bit)
%
O1
#100=12 AND 10
#101=12 OR 10
#102=12 XOR 10
#103=5 AND #0
#104=5 OR #0
#105=-1 AND 255
M30
%
(EXPECT #100 = 8)
(EXPECT #101 = 14)
(EXPECT #102 = 6)
(EXPECT #103 = 0)
(EXPECT #104 = 5)
(EXPECT #105 = 255)

(CASE MB-068 beyond 32 bits)
%
O1
#1=99999999.*100.
#2=#1 AND 1
M30
%
(EXPECT ALARM 110 AT 4)

(CASE MB-073 minus before variable, bracket and function)
%
O1
#2=3
#100=-#2
#101=-[#2+1]
#102=-SIN[90]
#103=-5+2
#104=-#2*2
M30
%
(EXPECT #100 = -3)
(EXPECT #101 = -4)
(EXPECT #102 = -1)
(EXPECT #103 = -3)
(EXPECT #104 = -6)

(CASE MB-074 a comparison is no number)
%
O1
#2=[1 LT 2]
M30
%
(EXPECT ALARM FORMAT AT 3)

(CASE MB-074 nor in a word)
%
O1
G0 X[1 LT 2]
M30
%
(EXPECT ALARM FORMAT AT 3)

(CASE MB-074 nor in the number of a variable)
%
O1
#1=#[1 EQ 1]
M30
%
(EXPECT ALARM FORMAT AT 3)

(CASE MB-076 EQ and NE are exact)
%
O1
#1=1/3
IF[#1EQ.33333333]THEN #100=1
IF[#1NE.33333333]THEN #101=1
IF[#1EQ1/3]THEN #102=1
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 1)
(EXPECT #102 = 1)

(CASE MB-077 keywords by their first two letters)
%
O1
WH[#100LT2]DO1
#100=#100+1
EN1
#101=SQ[16]
#102=RO[2.5]
#103=FI[2.9]
#104=FU[2.1]
#105=AB[-4]
IF[#101EQ4]TH #106=1
#107=SI[30]
#108=CO[60]
#109=TA[45]
#110=AT[1]
#111=BC[10]
#112=BI[16]
GO5
#113=1
N5
M30
%
(EXPECT #100 = 2)
(EXPECT #101 = 4)
(EXPECT #102 = 3)
(EXPECT #103 = 2)
(EXPECT #104 = 3)
(EXPECT #105 = 4)
(EXPECT #106 = 1)
(EXPECT #107 = 0.5)
(EXPECT #108 = 0.5)
(EXPECT #109 = 1)
(EXPECT #110 = 45)
(EXPECT #111 = 16)
(EXPECT #112 = 10)
(EXPECT #113 = VACANT)

(CASE MB-077 output statements by two letters)
%
O1
PO
DP[A]
PC
M30
%
(EXPECT OUTPUT "A\n")

(CASE MB-046 parameter 6008.0 gives the 30i the range of the 16i)
(CONTROL fanuc-30i)
(PARAMETER 6008.0 = 1)
%
O1
#100=EXP[100]
#101=#100*10000.
M30
%
(EXPECT ALARM 111 AT 6)

(CASE MB-077 operators by their first two letters)
%
O1
#100=7 AN 3
#101=1 XO 3
#102=27 MO 20
#103=4 OR 1
M30
%
(EXPECT #100 = 3)
(EXPECT #101 = 2)
(EXPECT #102 = 7)
(EXPECT #103 = 5)

(CASE MB-040 the number of a variable has no decimal point)
%
O1
#100.5=3
M30
%
(EXPECT ALARM FORMAT AT 3)

(CASE MB-040 as a value neither)
%
O1
#1=#100.5
M30
%
(EXPECT ALARM FORMAT AT 3)
