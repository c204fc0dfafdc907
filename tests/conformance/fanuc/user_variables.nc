(Local and common variables: MB-095 to MB-107.)

(CASE MB-095 the variables that exist)
%
O1
#1=1
#33=2
#100=3
#149=4
#500=5
#531=6
#101=#1+#33+#100+#149+#500+#531
M30
%
(EXPECT #101 = 21)

(CASE MB-095 the long ranges)
%
O1
#199=1
#999=2
#100=#199+#999
M30
%
(EXPECT #100 = 3)

(CASE MB-095 the 30i has #98000 to #98499)
(CONTROL fanuc-30i)
%
O1
#98000=4
#98499=5
#100=#98000+#98499
M30
%
(EXPECT #100 = 9)

(CASE MB-096 a macro has locals of its own, M98 shares them)
%
O1
#1=1
#2=2
G65 P9500 B5.
#104=#1
#105=#2
M98 P9501
#106=#1
#107=#3
M30
O9500
#100=#1
#101=#2
#2=99
M99
O9501
#102=#1
#1=77
#3=78
M99
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 5)
(EXPECT #102 = 1)
(EXPECT #104 = 1)
(EXPECT #105 = 2)
(EXPECT #106 = 77)
(EXPECT #107 = 78)

(CASE MB-099 a computed number is rounded)
%
O1
#5=50
#6=60
#100=#[5.4]
#101=#[5.5]
M30
%
(EXPECT #100 = 50)
(EXPECT #101 = 60)

(CASE MB-100 two signs in a row)
%
O1
#1=5
#100=##1
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE MB-100 indirection through brackets)
%
O1
#1=2
#2=3
#3=44
#100=#[#[#1]]
#101=#[#[#1]-1]
M30
%
(EXPECT #100 = 44)
(EXPECT #101 = 3)

(CASE MB-101 indirection on the left)
%
O1
#1=3
#[#1]=6.5
#100=#3
#[#1*2+500]=8
M30
%
(EXPECT #100 = 6.5)
(EXPECT #506 = 8)

(CASE MB-102 #34 does not exist)
%
O1
#1=#34
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-102 #99 does not exist)
%
O1
#1=#99
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-102 #200 does not exist)
%
O1
#1=#200
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-102 #499 does not exist)
%
O1
#1=#499
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-102 nor can it be set)
%
O1
#34=1
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-102 a negative number)
%
O1
#1=#[-1]
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-103 a variable that can only be read)
%
O1
#5001=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-106 pi, e and vacant on the 30i)
(CONTROL fanuc-30i)
%
O1
#100=[#_PI]
#101=[#_E]
#102=[#_EMPTY]
#103=#3101
#104=#3102
#105=#3100
M30
%
(EXPECT #100 = 3.14159265359)
(EXPECT #101 = 2.71828182846)
(EXPECT #102 = VACANT)
(EXPECT #103 = 3.14159265359)
(EXPECT #104 = 2.71828182846)
(EXPECT #105 = VACANT)

(CASE MB-107 a protected range of #500 to #999)
(PARAMETER 6031 = 510)
(PARAMETER 6032 = 510)
%
O1
#509=1
#511=2
#510=3
M30
%
(EXPECT #509 = 1)
(EXPECT #511 = 2)
(EXPECT ALARM 116 AT 7)

(CASE MB-107 it can be read)
(PARAMETER 6031 = 500)
(PARAMETER 6032 = 599)
(SET #510 = 4)
%
O1
#100=#510
M30
%
(EXPECT #100 = 4)

(CASE MB-104 SETVN names variables, and a name stands on both sides)
(CONTROL fanuc-30i)
%
O1
SETVN 500[TOOL_NO,WORK2]
[#TOOL_NO]=4.
#501=[#TOOL_NO]+1
#100=[#WORK2]
SETVN 100[A_NAME_OF_THIRTY_ONE_CHARACTERS]
G0 X[#TOOL_NO]
M30
%
(EXPECT #500 = 4)
(EXPECT #501 = 5)
(EXPECT MOVE 1 G0 X4)

(CASE MB-104 on the 16i names only show on its screen)
(CONTROL fanuc-16i)
%
O1
SETVN 500[TOOLNO,EIGHTCHR]
#500=4.
M30
%
(EXPECT #500 = 4)

(CASE MB-104 of #500 to #519)
(CONTROL fanuc-16i)
%
O1
SETVN 519[LAST,BEYOND]
M30
%
(EXPECT ALARM 115 AT 4)

(CASE MB-104 with at most eight characters)
(CONTROL fanuc-16i)
%
O1
SETVN 500[NINECHARS]
M30
%
(EXPECT ALARM 114 AT 4)

(CASE MB-105 names of the system)
(CONTROL fanuc-30i)
(START X = 1)
(SET #1003 = 1)
(SET #3901 = 12)
(SIGNAL X5.)
%
O1
G92 X3.
G31 X20. F100.
#100=[#_ABSIO[1]]
#101=[#_ABSMT[1]]
#102=[#_ABSOT[1]]
#103=[#_ABSKP[1]]
[#_WZG54[2]]=7.
#104=#5222
[#_WZG59[3]]=8.
#105=#5323
[#_WZP1[2]]=9.
#106=#7002
[#_WZCMN[1]]=0
#107=[#_UI[3]]
[#_UO[5]]=1
#108=#1105
[#_CLOCK1]=500
#109=#3001
#110=[#_PRTSA]
#111=[#_TOFS[3]]
M30
%
(EXPECT #100 = 7)
(EXPECT #101 = 5)
(EXPECT #102 = 7)
(EXPECT #103 = 7)
(EXPECT #104 = 7)
(EXPECT #105 = 8)
(EXPECT #106 = 9)
(EXPECT #107 = 1)
(EXPECT #108 = 1)
(EXPECT #109 = 500)
(EXPECT #110 = 12)
(EXPECT #111 = 0)

(CASE MB-104 an empty name takes the name, as a control punches variables without one)
(CONTROL fanuc-30i)
%
O1
SETVN500[TOOL_NO]
SETVN501[]
SETVN500[]
[#TOOL_NO]=4.
M30
%
(EXPECT ALARM 1098 AT 7)
